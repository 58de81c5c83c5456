#pragma once

#include <doctest/doctest.h>

#include "knotwork/scene/commands.h"

namespace knotwork::scene {

/// The error of a command that must be refused and change nothing.
inline Error refusal(Document document, const Command& command) {
  const Document before = document;
  const Status status = apply(document, command);
  CHECK(document == before);
  REQUIRE_FALSE(status);
  CHECK_FALSE(status.error().message.empty());
  return status.error();
}

}  // namespace knotwork::scene
