// Small texts, drawn.
#pragma once

#include <doctest/doctest.h>

#include <string_view>
#include <utility>

#include "models/bunch/paper/skeleton_drawing.hpp"
#include "models/bunch/roles.hpp"

namespace panicle::tests {

// The drawing of `text`, from the origin straight down, interpreted once and finished.
inline bunch::SkeletonDrawing drawn_text(std::string_view text) {
  bunch::SkeletonDrawing drawing{Limits{}};
  auto program = lsystem::compile(text, {}, lsystem::Lineages::always);
  REQUIRE_MESSAGE(program, (program ? "" : program.error().message));
  const auto bound = lsystem::bind(program.value(), {}, {});
  REQUIRE(bound);
  const auto derived = lsystem::develop(*bound.value(), 1, {}, {});
  REQUIRE(derived);
  std::vector<std::string> notes;
  drawing.begin(*bound.value(), bunch::roles_of(*program.value(), notes), false, 0);
  REQUIRE(lsystem::interpret(*bound.value(), *derived->string, {}, drawing, 1, {}));
  return drawing;
}

inline bunch::SkeletonDrawing finished_text(std::string_view text) {
  bunch::SkeletonDrawing drawing = drawn_text(text);
  drawing.finish();
  return drawing;
}

}  // namespace panicle::tests
