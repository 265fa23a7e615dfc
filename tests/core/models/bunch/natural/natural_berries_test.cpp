// The berries of a natural bunch: colour and size by where they hang, and their skins.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/bunch/berry/berry_meridian.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

TEST_CASE("sun colours the lit side first; little vigour leaves the far berries small") {
  BunchRequest request = natural_request(table3[2].profile());
  set(request, Parameter::age, 75);
  set(request, Parameter::sun, 90);
  set(request, Parameter::sunlight, 1);
  const GrownBunch lit = grown(request);
  double right = 0, left = 0;
  int rights = 0, lefts = 0;
  for (std::size_t i = 0; i < lit.berries.size(); ++i) {
    (lit.berries[i].centre.x > 0 ? right : left) += lit.traits[i].turned;
    ++(lit.berries[i].centre.x > 0 ? rights : lefts);
  }
  CHECK(right / rights > left / lefts + 0.02);

  BunchRequest weak = natural_request(table3[2].profile());
  set(weak, Parameter::vigour, 0);
  set(weak, Parameter::spread, 2);
  const GrownBunch poor = grown(weak);
  double near = 0, far = 0;
  int nears = 0, fars = 0;
  for (std::size_t i = 0; i < poor.berries.size(); ++i) {
    const bool upper = poor.berries[i].centre.y > -0.1f;
    (upper ? near : far) += poor.traits[i].width;
    ++(upper ? nears : fars);
  }
  CHECK(near / nears > 1.03 * far / fars);
}

TEST_CASE("pressed berries hold their volume within 3 %, however dense the bunch") {
  for (const float density : {5.0f, 7.0f, 9.0f}) {
    BunchRequest request = natural_request(table3[0].profile());
    set(request, Parameter::density, density);
    request.meshes = true;
    const GrownBunch bunch = grown(request);
    const BerrySurfaces& surfaces = *bunch.surfaces;
    const std::size_t vertices = surfaces.uvs.size() / 2;
    double worst = 0;
    for (std::size_t i = 0; i < bunch.berries.size(); ++i) {
      const auto at = [&](std::size_t k) {
        const float* const p = surfaces.positions.data() + 3 * (i * vertices + surfaces.indices[k]);
        return glm::dvec3(p[0], p[1], p[2]) - glm::dvec3(bunch.berries[i].centre);
      };
      double volume = 0;
      for (std::size_t k = 0; k < surfaces.indices.size(); k += 3)
        volume += glm::dot(at(k), glm::cross(at(k + 1), at(k + 2))) / 6;
      const double free = form_volume(bunch.form, bunch.traits[i].width / 2, bunch.traits[i].length / 2);
      worst = std::max(worst, std::abs(volume / free - 1));
    }
    MESSAGE("density " << density << ", " << bunch.berries.size() << " berries: volume off by " << 100 * worst
                       << " % at the most");
    CHECK(worst < 0.03);
  }
}

TEST_CASE("the number of segments depends on the size of berries in the picture, not on their number") {
  const auto vertices_each = [](float age, float millimetres) {
    BunchRequest request = natural_request(table3[0].profile());
    set(request, Parameter::age, age);
    set(request, Parameter::size, millimetres);
    request.meshes = true;
    const GrownBunch bunch = grown(request);
    REQUIRE(!bunch.berries.empty());
    return bunch.surfaces->positions.size() / 3 / bunch.berries.size();
  };
  const std::size_t flowers = vertices_each(0, 18), ripe = vertices_each(100, 18), small = vertices_each(100, 9);
  CHECK(3 * flowers < ripe);
  CHECK(flowers < small);
  CHECK(small < ripe);
}

TEST_CASE("dried berries are furrowed in the mesh as far as their traits say") {
  BunchRequest request = natural_request(table3[0].profile());
  set(request, Parameter::age, 125);
  request.meshes = true;
  request.berry_segments = 24;
  const GrownBunch bunch = grown(request);
  std::vector<BerryBody> bodies;
  for (std::size_t i = 0; i < bunch.berries.size(); ++i) {
    const Traits& traits = bunch.traits[i];
    CHECK(traits.shrivel > 0.3f);
    bodies.push_back({bunch.berries[i].centre * 1000.0f, bunch.berries[i].direction, traits.width * 500,
                      traits.length * 500, traits.shrivel, bunch.berries[i].id});
  }
  // The same bodies pressed apart from the growth.
  BerryOptions options;
  options.segments = request.berry_segments;
  const BerrySurfaces surfaces = press_berries(bodies, bunch.form, options);
  REQUIRE(surfaces.positions.size() == bunch.surfaces->positions.size());
  float worst = 0;
  for (std::size_t i = 0; i < surfaces.positions.size(); ++i)
    worst = std::max(worst, std::abs(surfaces.positions[i] - 1000 * bunch.surfaces->positions[i]));
  CHECK(worst < 0.05f);  // millimetres; furrows are deeper by far
}
