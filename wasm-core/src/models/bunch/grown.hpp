// The result of growing a bunch, in metres: the only data that scene, exporters and panels read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lsystem/trace/derivation_trace.hpp"
#include "mesh/mesh.hpp"
#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/berry/flower.hpp"
#include "models/bunch/berry/pressing/berry_surfaces.hpp"
#include "models/bunch/plan.hpp"
#include "models/bunch/skeleton.hpp"
#include "stems/tubes.hpp"

namespace panicle::bunch {

struct Counts {
  std::uint32_t end_structures = 0;
  std::uint32_t internodes = 0;
  std::uint32_t pedicels = 0;
  std::uint32_t berries = 0;
  std::uint32_t withered = 0;
  // internodes that found no room; neither they nor the parts beyond them are in any other count
  std::uint32_t cut = 0;
};

// Properties of a berry besides its place. All are floats, and cross the WebAssembly boundary unchanged, in this order.
struct Traits {
  float width = 0;     // across its direction, metres
  float length = 0;    // along it, metres
  float exposure = 0;  // 0 … 1: share of the sun's light that reaches it
  float turned = 1;    // 0 … 1: from the unripe colour to the ripe one
  float opened = 1;    // 0 … 1: the flower, from closed bud to open; stays 1 afterwards
  float set = 1;       // 0 … 1: from open flower (stamens) to berry
  float shrivel = 0;   // 0 … 1
  float seeds = 0;     // 0 … 4
};

// The reason for a pedicel without a berry.
enum class RemovalReason : std::uint32_t {
  not_set = 1,  // its flower did not set: more flowers than berries are wanted
  no_room = 2,  // pressed harder than berries can be
  outside = 3,  // did not stay within the outline
  by_hand = 4,  // listed in the request
};

struct Thinned {
  std::uint32_t id = 0;
  RemovalReason why = RemovalReason::not_set;
  glm::vec3 place{0};  // where its pedicel begins, metres
};

// A part of the foliage's mesh.
struct FoliagePart : MeshRange {
  enum class Kind : std::uint32_t { cane = 0, leaf = 1, petiole = 2 };
  Kind kind = Kind::cane;
};

struct Foliage {
  Mesh mesh;  // metres
  std::vector<FoliagePart> parts;
};

// The share of the sky that every vertex sees, 0 … 255 (light/sky.hpp).
struct SkyBytes {
  std::vector<std::uint8_t> stems, foliage;  // one a vertex of that mesh
  std::vector<std::uint8_t> berries;         // one a vertex of each berry: pattern vertices × berries
};

// The work of swelling a bunch, counted for tests of its cost.
struct SwellingWork {
  std::uint64_t steps = 0;           // steps of growth
  std::uint64_t looks = 0;           // tests of pairs of berries, and of a berry and a stem, that might touch
  std::uint64_t contacts = 0;        // pairs that touched, and were moved
  std::uint64_t thinning_looks = 0;  // tests of pairs, to find the berries that have no room
};

struct GrownBunch {
  bool natural = false;  // whether the natural procedure grew it
  BerryForm form;
  // of the natural procedure: the handles' profile, varied by the seed; the outline that the bunch fills
  Profile profile;
  Plan plan;  // the handles' plan
  std::optional<Plan> second;
  Counts counts;
  SwellingWork swelling;              // of the natural procedure
  std::vector<Internode> internodes;  // parents first
  std::int32_t second_root = -1;      // the first internode of a second bunch that shares the first one's root
  std::vector<Berry> berries;
  std::vector<Traits> traits;    // one a berry
  std::vector<Thinned> thinned;  // the natural procedure's
  std::vector<float> measures;   // in the order of measures.generated.hpp; NaN: does not apply; empty: not requested
  std::optional<StemMesh> stem;
  std::optional<Mesh> berry;              // the shared berry, unit radius
  std::optional<BerrySurfaces> surfaces;  // the natural procedure's berries, each with its own surface
  std::optional<FlowerMesh> flower;       // the shared flower, where a berry has not yet set or keeps its sepals
  std::optional<Foliage> foliage;         // leaves and cane, if requested
  std::optional<SkyBytes> sky;            // if requested
  std::optional<lsystem::DerivationTrace> trace;  // if requested: how the first bunch's text was derived
  std::vector<std::string> notes;
  std::uint64_t fingerprint = 0;       // skeleton and organs (docs/fingerprint.md)
  std::uint64_t mesh_fingerprint = 0;  // 0 without meshes
};

}  // namespace panicle::bunch
