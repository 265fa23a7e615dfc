#include "light/sky.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/random.hpp"

using namespace panicle;

namespace {

constexpr glm::vec3 up{0, 1, 0};

SkyBody ball(const glm::vec3& centre, float radius, std::int32_t owner = -1) {
  return {centre, radius * radius, glm::vec3(0), owner};
}

int seen(Sky& sky, const glm::vec3& place, const glm::vec3& normal, const SkyReceiver& receiver) {
  sky.set_receiver(receiver);
  std::uint8_t byte = 0;
  sky.sample(std::span(&place.x, 3), std::span(&normal.x, 3), std::span(&byte, 1));
  return byte;
}

int seen(std::span<const SkyBody> balls, const glm::vec3& place, const glm::vec3& normal,
         std::span<const SkyBody> specks = {}) {
  Sky sky(balls, specks);
  return seen(sky, place, normal, {place, 0.001f});
}

// A random number that is spread as numbers from −1 to 1.
float spread(std::uint64_t seed, std::uint64_t stream, std::uint64_t i) { return 2 * random_unit(seed, stream, i) - 1; }

glm::vec3 direction(std::uint64_t seed, std::uint64_t stream) {
  for (std::uint64_t i = 0;; ++i) {
    const glm::vec3 v(spread(seed, stream, 3 * i), spread(seed, stream, 3 * i + 1), spread(seed, stream, 3 * i + 2));
    const float square = glm::dot(v, v);
    if (square > 0.01f && square < 1) return v / std::sqrt(square);
  }
}

// The share of rays, spread as the cosine, that pass all balls: in 255ths.
double traced(std::span<const SkyBody> balls, const glm::vec3& place, const glm::vec3& normal) {
  constexpr int rays = 4000;
  const glm::vec3 across = glm::normalize(glm::cross(normal, std::fabs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : up));
  const glm::vec3 along = glm::cross(normal, across);
  int open = 0;
  for (int k = 0; k < rays; ++k) {
    const float part = (static_cast<float>(k) + 0.5f) / rays, turn = 2.39996323f * static_cast<float>(k);
    const float sine = std::sqrt(part), cosine = std::sqrt(1 - part);
    const glm::vec3 ray = across * (sine * std::cos(turn)) + along * (sine * std::sin(turn)) + normal * cosine;
    open += std::none_of(balls.begin(), balls.end(), [&](const SkyBody& one) {
      const glm::vec3 to = one.centre - place;
      const float ahead = glm::dot(to, ray);
      return ahead > 0 && glm::dot(to, to) - ahead * ahead < one.square;
    });
  }
  return 255.0 * open / rays;
}

// Balls of like size, about a place that none reaches: at most so far from it.
std::vector<SkyBody> soup(std::uint64_t seed, std::size_t count, float room = 0.9f) {
  std::vector<SkyBody> balls;
  for (std::size_t i = 0; i < count; ++i) {
    const float radius = 0.85f + 0.15f * spread(seed, 20, i);
    const float away = radius * 1.1f + room * random_unit(seed, 21, i);
    balls.push_back(ball(away * direction(seed, 100 + i), radius));
  }
  return balls;
}

}  // namespace

TEST_CASE("without bodies all of the sky is visible") { CHECK(seen({}, {1, 2, 3}, up) == 255); }

TEST_CASE("a ball above the horizon hides sin²α · cos γ, independent of bodies behind") {
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const float lift = 0.05f + 0.015f * static_cast<float>(k), away = 1.3f + 0.05f * static_cast<float>(k % 20);
    const glm::vec3 way(std::sqrt(1 - lift * lift), lift, 0);
    const float sine = 1 / away;
    const SkyBody one = ball(away * way, 1);
    if (lift < sine) continue;
    CHECK(std::abs(seen(std::span(&one, 1), glm::vec3(0), up) - 255 * (1 - sine * sine * lift)) <= 1);
    CHECK(seen(std::span(&one, 1), glm::vec3(0), -up) == 255);
  }
}

TEST_CASE("a wall hides all of the sky before it, and none behind") {
  const SkyBody wall = ball({0, 1001, 0}, 1000);
  CHECK(seen(std::span(&wall, 1), {0, 0.99f, 0}, up) <= 1);
  CHECK(seen(std::span(&wall, 1), {0, 0.99f, 0}, -up) == 255);
}

TEST_CASE("the sky changes smoothly while a ball sets below the horizon") {
  int before = -1;
  for (int k = -100; k <= 100; ++k) {
    const float angle = 1.5f * static_cast<float>(k) / 100;
    const SkyBody one = ball({2 * std::cos(angle), 2 * std::sin(angle), 0}, 1);
    const int now = seen(std::span(&one, 1), glm::vec3(0), up);
    if (before >= 0) CHECK(std::abs(now - before) <= 2);
    if (k == -100) CHECK(now == 255);
    if (k == 100) CHECK(now == doctest::Approx(255 * 0.75).epsilon(0.01));
    before = now;
  }
}

TEST_CASE("the sky between many balls agrees with ray casting") {
  for (const std::size_t count : {std::size_t{2}, std::size_t{5}, std::size_t{8}}) {
    double error = 0, bias = 0;
    constexpr int times = 120;
    for (std::uint64_t seed = 0; seed < times; ++seed) {
      const std::vector<SkyBody> balls = soup(1000 * count + seed, count, 3);
      const glm::vec3 normal = direction(seed, 7);
      const double off = seen(balls, glm::vec3(0), normal) - traced(balls, glm::vec3(0), normal);
      error += std::fabs(off) / times;
      bias += off / times;
      CHECK(std::fabs(off) < 60);
    }
    CAPTURE(count);
    CHECK(error < 12);
    CHECK(std::fabs(bias) < 8);
  }
}

TEST_CASE("an additional ball never increases the sky") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const std::vector<SkyBody> balls = soup(seed, Sky::nearest);
    const glm::vec3 normal = direction(seed, 8);
    int before = 255;
    for (std::size_t count = 1; count <= balls.size(); ++count) {
      const int now = seen(std::span(balls).first(count), glm::vec3(0), normal);
      CHECK(now <= before);
      before = now;
    }
    // Bodies that are only summed up may differ slightly.
    const std::vector<SkyBody> many = soup(seed, 40);
    CHECK(seen(many, glm::vec3(0), normal) <= before + 12);
  }
}

TEST_CASE("the sky is invariant under rotation") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const glm::vec3 x = direction(seed, 1), y = glm::normalize(glm::cross(x, direction(seed, 2))), z = glm::cross(x, y);
    const auto turned = [&](const glm::vec3& v) { return x * v.x + y * v.y + z * v.z; };
    std::vector<SkyBody> balls = soup(seed, 30), specks = soup(seed + 500, 20);
    for (SkyBody& speck : specks) {
      speck.square *= 0.04f;
      speck.facing = direction(seed, 300 + static_cast<std::uint64_t>(&speck - specks.data()));
    }
    const glm::vec3 normal = direction(seed, 9);
    const int before = seen(balls, glm::vec3(0), normal, specks);
    for (std::vector<SkyBody>* bodies : {&balls, &specks})
      for (SkyBody& one : *bodies) {
        one.centre = turned(one.centre);
        one.facing = turned(one.facing);
      }
    CHECK(std::abs(seen(balls, glm::vec3(0), turned(normal), specks) - before) <= 1);
  }
}

TEST_CASE("a point in a frame sees the same sky as outside of it") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    const glm::vec3 x = direction(seed, 1), y = glm::normalize(glm::cross(x, direction(seed, 2))), z = glm::cross(x, y);
    const SkyFrame frame{0.3f * direction(seed, 3), x, y, z, 0.2f};
    const glm::vec3 place = 0.5f * direction(seed, 4), normal = direction(seed, 5);
    const auto turned = [&](const glm::vec3& v) { return x * v.x + y * v.y + z * v.z; };
    std::vector<SkyBody> balls = soup(seed, 30), specks = soup(seed + 500, 20);
    for (SkyBody& speck : specks) speck.square *= 0.04f;
    Sky sky(balls, specks);
    const SkyReceiver receiver{frame.centre, 0.2f};
    const int outside = seen(sky, frame.centre + 0.2f * turned(place), turned(normal), receiver);
    sky.set_receiver(receiver);
    sky.set_frame(frame);
    std::uint8_t byte = 0;
    sky.sample(std::span(&place.x, 3), std::span(&normal.x, 3), std::span(&byte, 1));
    CHECK(std::abs(byte - outside) <= 1);
  }
}

TEST_CASE("a body hides no sky from itself, its parent, its children and its siblings") {
  SkyBody speck{{0, 1, 0}, 0.5f, glm::vec3(0), 5, 3};
  const auto hides_from = [&](std::int32_t owner, std::int32_t parent) {
    Sky sky({}, std::span(&speck, 1));
    return seen(sky, glm::vec3(0), up, {glm::vec3(0), 0.1f, owner, parent}) < 250;
  };
  CHECK(hides_from(-1, -1));
  CHECK(hides_from(9, 8));
  CHECK(!hides_from(5, 8));  // its own
  CHECK(!hides_from(9, 5));  // attached to it
  CHECK(!hides_from(3, 1));  // its parent
  CHECK(!hides_from(6, 3));  // of the same parent
  speck.owner = speck.parent = -1;
  CHECK(hides_from(-1, -1));
  const SkyBody own = ball({0, 2, 0}, 1, 4);
  Sky sky(std::span(&own, 1), {});
  CHECK(seen(sky, glm::vec3(0), up, {glm::vec3(0), 0.1f, 4, -1}) == 255);
  CHECK(seen(sky, glm::vec3(0), up, {glm::vec3(0), 0.1f, 3, -1}) < 200);
}

TEST_CASE("a disc hides its projected area; a ball the same in all directions") {
  const float away = 2, square = 0.25f;
  const auto hidden = [&](const glm::vec3& facing) {
    const SkyBody disc{{0, away, 0}, square, facing};
    return 255 - seen({}, glm::vec3(0), up, std::span(&disc, 1));
  };
  CHECK(hidden({1, 0, 0}) == 0);
  const double sum = square / (away * away) * 0.75, all = 255 * (1 - std::exp(-sum));  // 1/4 + cos γ / 2 of sin²α
  CHECK(std::abs(hidden(up) - all) <= 1);
  CHECK(hidden(-up) == hidden(up));
  CHECK(hidden(glm::vec3(0)) == hidden(up));
  CHECK(std::abs(hidden(glm::normalize(glm::vec3(1, 1, 0))) - 255 * (1 - std::exp(-sum * std::sqrt(0.5)))) <= 1);
}

TEST_CASE("bodies that are not finite or have no size are ignored") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const SkyBody odd[] = {ball({nan, 1, 0}, 1),      ball({0, infinity, 0}, 1), ball({0, 2, 0}, nan),
                         ball({0, 2, 0}, infinity), ball({0, 2, 0}, 0),        {{0, 2, 0}, -1}};
  CHECK(seen(odd, glm::vec3(0), up, odd) == 255);
  const SkyBody one = ball({0, 2, 0}, 1);
  CHECK(seen(std::span(&one, 1), {nan, nan, nan}, up) >= 0);  // any byte, and no trap
}

TEST_CASE("sample gives the same for many points as for each alone") {
  const std::vector<SkyBody> balls = soup(3, 12);
  Sky sky(balls, {});
  for (std::size_t count = 0; count <= 9; ++count) {
    std::vector<float> places(3 * count), normals;
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = 0.05f * spread(4, 1, i);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec3 n = direction(5, i);
      normals.insert(normals.end(), {n.x, n.y, n.z});
    }
    const SkyReceiver receiver{glm::vec3(0), 0.1f};
    sky.set_receiver(receiver);
    std::vector<std::uint8_t> bytes(count);
    sky.sample(places, normals, bytes);
    for (std::size_t i = 0; i < count; ++i)
      CHECK(bytes[i] == seen(sky, {places[3 * i], places[3 * i + 1], places[3 * i + 2]},
                             {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}, receiver));
  }
}

TEST_CASE("bodies behind a point do not change its sky") {
  std::vector<SkyBody> behind;
  for (int k = 0; k < 40; ++k)
    behind.push_back(ball(glm::vec3(0.05f * static_cast<float>(k % 5), -1 - 0.1f * static_cast<float>(k), 0), 0.3f, k));
  CHECK(seen({}, glm::vec3(0), up, behind) == 255);
  CHECK(seen(behind, glm::vec3(0), up) == 255);
  CHECK(seen(behind, glm::vec3(0), -up) < 200);
}
