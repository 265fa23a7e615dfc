#include "stems/segment.hpp"

#include <doctest/doctest.h>

using namespace panicle;

TEST_CASE("scale multiplies a segment's places and radii, and nothing else") {
  Segment segment{3, 2, {1, 2, 3}, {4, 5, 6}, 0.5f, 0.25f};
  scale(segment, 2);
  CHECK(segment.parent == 3);
  CHECK(segment.tag == 2);
  CHECK(segment.start == glm::vec3(2, 4, 6));
  CHECK(segment.end == glm::vec3(8, 10, 12));
  CHECK(segment.radius == 1);
  CHECK(segment.radius_end == 0.5f);
}
