#pragma once

#include <cstdint>

namespace knotwork::web {

/// How often memory has been asked for since start: each operator new, and what Dear ImGui takes.
std::int64_t allocation_count();

/// Dear ImGui's memory is counted too. Before its context is made.
void count_interface_allocations();

}  // namespace knotwork::web
