#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "unit/float_traps.h"
#include "unit/oracle.h"

namespace {

/// The oracles are the files 01_... and so on. Prints the cases that no test has read; true when there are none.
bool every_oracle_case_read() {
  int oracles = 0;
  for (const auto& entry : std::filesystem::directory_iterator(KNOTWORK_TEST_DATA_DIR)) {
    const std::string name = entry.path().filename().string();
    if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) continue;
    knotwork::test::load_oracle(name);
    ++oracles;
  }
  int unread = 0;
  for (const std::string& name : knotwork::test::oracle_files().unread()) {
    if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) continue;
    std::printf("no test has read this case of an oracle: %s\n", name.c_str());
    ++unread;
  }
  return unread == 0 && oracles > 0;
}

}  // namespace

/// Beside doctest's options: --every-oracle-case, for a run of all unit tests, fails when one of the oracles' cases was
/// read by none of them.
int main(int argc, char** argv) {
  // The command line decides first: a listing or a wrong option ends here and needs no traps.
  doctest::Context context(argc, argv);
  knotwork::test::trap_float_errors();
  const int status = context.run();
  bool complete = true;
  for (int k = 1; k < argc; ++k) {
    if (std::string_view(argv[k]) == "--every-oracle-case") complete = every_oracle_case_read();
  }
  return status != 0 ? status : complete ? 0 : 1;
}
