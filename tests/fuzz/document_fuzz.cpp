// An entry for libFuzzer; the same properties run without it in document_mutation_test.cpp. With Clang:
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -Icore -Itests -isystem <eigen>
//     tests/fuzz/document_fuzz.cpp core/knotwork/*/*.cpp -o document_fuzz
//   ./document_fuzz tests/data/documents

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/document_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {  // NOLINT: libFuzzer's name
  bool accepted = false;
  if (!knotwork::test::text_is_handled({reinterpret_cast<const char*>(bytes), size}, accepted)) std::abort();
  return 0;
}
