#include "web/allocations.h"

#include <imgui.h>

#include <cstdlib>
#include <new>

namespace {

std::int64_t allocations = 0;  // NOLINT: operator new has no other place

}  // namespace

// Replaces the library's: the same, and counted. Without exceptions there is nothing else to do when memory is out.
void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) std::abort();
  return memory;
}
void* operator new[](std::size_t size) { return ::operator new(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace knotwork::web {

std::int64_t allocation_count() { return allocations; }

void count_interface_allocations() {
  ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return ::operator new(size); },
                               [](void* memory, void*) { ::operator delete(memory); });
}

}  // namespace knotwork::web
