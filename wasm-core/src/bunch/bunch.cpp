#include "bunch/bunch.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bunch/builtin_grammars.hpp"
#include "bunch/growth.hpp"
#include "bunch/parameters.generated.hpp"
#include "foundation/fingerprint.hpp"
#include "foundation/random.hpp"
#include "geometry/berry.hpp"
#include "lsystem/lsystem.hpp"

namespace panicle::bunch {
namespace {

constexpr std::int32_t most_segments = 10000;  // of one axis, asked for in place of the profile's
constexpr float metres_per_millimetre = 0.001f;

// A request's parameters, complete and in range.
class Values {
 public:
  Values(const std::vector<float>& asked, std::vector<std::string>& notes) {
    for (std::uint32_t i = 0; i < parameter_count; ++i) {
      const ParameterInfo& info = parameter_table[i];
      given_[i] = i < asked.size() && asked[i] == asked[i];
      values_[i] = given_[i] ? admitted(asked[i], info, notes) : info.standard;
    }
  }

  float operator[](Parameter key) const { return values_[static_cast<std::uint32_t>(key)]; }

  // The values that replace a #define: those given, and no others, so that a text's own constants stand.
  std::vector<lsystem::Inputs::Scalar> defines() const {
    std::vector<lsystem::Inputs::Scalar> scalars;
    for (std::uint32_t i = 0; i < parameter_count; ++i)
      if (given_[i] && !parameter_table[i].define.empty())
        scalars.push_back({std::string(parameter_table[i].define), values_[i]});
    return scalars;
  }

 private:
  static float admitted(float value, const ParameterInfo& info, std::vector<std::string>& notes) {
    float fitting = std::clamp(value, info.min, info.max);
    if (fitting > 0 && fitting < info.gap_below) fitting = info.gap_below;
    if (info.whole) fitting = std::floor(fitting + 0.5f);
    if (fitting != value) notes.push_back("Parameter " + std::string(info.key) + " was brought into its range.");
    return fitting;
  }

  std::array<float, parameter_count> values_ = {};
  std::array<bool, parameter_count> given_ = {};
};

// What a person may wonder at: parameters without effect, a bunch that is not all there.
void remark(const lsystem::Program& program, const std::vector<lsystem::Inputs::Scalar>& defines, const Growth& growth,
            std::vector<std::string>& notes) {
  const std::span<const lsystem::Definition> known = lsystem::definitions(program);
  for (const lsystem::Inputs::Scalar& given : defines) {
    const bool found = std::any_of(known.begin(), known.end(), [&](const auto& one) { return one.name == given.name; });
    if (!found) notes.push_back("The grammar has no #define " + given.name + ", so its parameter changes nothing.");
  }
  if (growth.internodes.empty()) notes.push_back("The grammar drew nothing.");
  if (growth.rachis_cut)
    notes.push_back("The rachis found no room and ends early; smaller berries or thinner internodes leave it more.");
}

Profile profile_of(const Values& values) {
  using enum Parameter;
  return {values[l],
          {{{values[p3w], values[p3r]},
            {values[p4w], values[p4r]},
            {values[p5w], values[p5r]},
            {values[p6w], values[p6r]}}}};
}

// One bunch of the specimen: what its grammar counts and how far its lengths stretch.
struct Shape {
  Plan plan;
  Fit fit;
};

Shape shape_of(const Profile& profile, float fit) {
  Plan plan = make_plan(profile);
  const Fit lengths = make_fit(profile, plan, fit);
  return {std::move(plan), lengths};
}

// Segments asked for take the place of the profile's, whose lengths then no longer apply.
Result<Shape> asked_shape(const Request& request, const Profile& profile) {
  if (request.m < 0 || request.m > most_segments)
    return Diagnostic{Reason::bad_input, "m must be from 1 to 10000.", 0, 0};
  Shape shape{make_plan(profile, request.m), {}};
  if (request.n.empty()) return shape;
  const std::size_t axes = shape.plan.axes.size();
  if (request.n.size() != axes)
    return Diagnostic{Reason::bad_input,
                      "n needs m − 1 = " + std::to_string(axes) + " values, n1 first; it has " +
                          std::to_string(request.n.size()) + ".",
                      0, 0};
  for (std::size_t k = 0; k < axes; ++k) {
    if (request.n[k] < 0 || request.n[k] > most_segments)
      return Diagnostic{Reason::bad_input, "Every n must be from 0 to 10000.", 0, 0};
    shape.plan.axes[axes - 1 - k] = request.n[k];
  }
  return shape;
}

// The grammar's inputs: the paper counts axes from the tip, n_k = n(m − 1 − k).
lsystem::Inputs inputs_for(const Shape& shape, const Values& values) {
  lsystem::Inputs inputs{values.defines(), {}};
  inputs.scalars.push_back({"m", static_cast<float>(shape.plan.m)});
  inputs.scalars.push_back({"stretch", shape.fit.rachis});
  lsystem::Inputs::Array segments{"n", {}}, reach{"reach", {}};
  for (std::size_t k = shape.plan.axes.size(); k-- > 0;) {
    segments.values.push_back(static_cast<float>(shape.plan.axes[k]));
    reach.values.push_back(shape.fit.sides[k % 4] / shape.fit.rachis);
  }
  inputs.arrays = {std::move(segments), std::move(reach)};
  return inputs;
}

// One bunch of the specimen, derived and ready to be interpreted.
struct Stock {
  std::shared_ptr<const lsystem::Program> program;
  std::shared_ptr<const lsystem::String> string;
  std::uint64_t seed = 0;
  std::int32_t first_axis = 0;
  float lean = 0;  // degrees that the whole bunch leans to the left
};

Result<Stock> derive_stock(std::string_view grammar, std::uint64_t seed, const Shape& shape, const Values& values,
                           const Limits& limits) {
  auto program = lsystem::compile(grammar, inputs_for(shape, values), limits, lsystem::Lineages::always);
  if (!program) return program.error();
  auto derived = lsystem::unfold(*program.value(), seed, limits);
  if (!derived) return derived.error();
  return Stock{std::move(program.value()), std::move(derived->string), seed};
}

// Interprets a bunch into the growth, among what stands there already.
Diagnostic interpret(const Stock& stock, const Limits& limits, Growth& growth) {
  growth.begin(*stock.program, stock.seed, stock.first_axis);
  lsystem::Turtle turtle;
  lsystem::turn(turtle, -stock.lean);
  const auto drawn = lsystem::interpret(*stock.program, *stock.string, turtle, growth, stock.seed, limits);
  return drawn ? growth.trouble() : drawn.error();
}

// One bunch, or two on one peduncle. The second's rachis is laid first, for it would find no way through the first's
// berries; the berries of both come later, as in nature.
Diagnostic interpret_all(const Stock& first, const Stock* second, const Limits& limits, Growth& growth) {
  Diagnostic trouble;
  if (second) {
    growth.begin_laying();
    trouble = interpret(*second, limits, growth);
    growth.end_laying();
  }
  if (trouble.reason == Reason::none) trouble = interpret(first, limits, growth);
  if (trouble.reason == Reason::none && second) trouble = interpret(*second, limits, growth);
  return trouble;
}

void to_metres(std::vector<Internode>& internodes, std::vector<Berry>& berries, float scale) {
  for (Internode& internode : internodes) {
    internode.start *= scale;
    internode.end *= scale;
    internode.radius *= scale;
    internode.radius_end *= scale;
  }
  for (Berry& berry : berries) {
    berry.centre *= scale;
    berry.radius *= scale;
  }
}

Counts counted(const Grown& grown, std::uint32_t cut) {
  Counts counts;
  counts.internodes = static_cast<std::uint32_t>(grown.internodes.size());
  counts.berries = static_cast<std::uint32_t>(grown.berries.size());
  counts.cut = cut;
  for (const Internode& internode : grown.internodes) {
    counts.end_structures += internode.kind == Kind::end;
    counts.pedicels += internode.kind == Kind::pedicel;
    counts.withered += internode.state == State::withered;
  }
  return counts;
}

// docs/fingerprint.md has the order.
std::uint64_t fingerprint(const Grown& grown) {
  Fingerprint print;
  const auto point = [&print](const glm::vec3& p) {
    print.add(p.x);
    print.add(p.y);
    print.add(p.z);
  };
  for (const Internode& internode : grown.internodes) {
    print.add(static_cast<float>(internode.parent));
    print.add(static_cast<float>(internode.kind));
    print.add(static_cast<float>(internode.axis));
    print.add(static_cast<float>(internode.state));
    point(internode.start);
    point(internode.end);
    print.add(internode.radius);
    print.add(internode.radius_end);
  }
  for (const Berry& berry : grown.berries) {
    point(berry.centre);
    print.add(berry.radius);
    print.add(static_cast<float>(berry.parent));
  }
  return print.value();
}

void add_mesh(Fingerprint& print, const Mesh& mesh) {
  print.add(std::span<const float>(mesh.positions));
  print.add(std::span<const float>(mesh.normals));
  print.add(std::span<const float>(mesh.uvs));
  print.add(std::span<const std::uint32_t>(mesh.indices));
}

void add_meshes(Grown& grown, const Request& request) {
  TubeOptions tubes;
  if (request.stem_sides) tubes.sides = std::clamp(request.stem_sides, 3u, 64u);
  BerryOptions berry;
  if (request.berry_segments) berry.segments = std::clamp(request.berry_segments, 6u, 128u);
  grown.stem = sweep_stems(grown.internodes, tubes, 1.0f);
  grown.berry = make_berry(berry);
  Fingerprint print;
  add_mesh(print, grown.stem->mesh);
  add_mesh(print, *grown.berry);
  grown.mesh_fingerprint = print.value();
}

}  // namespace

Result<Grown> grow(const Request& request, const Limits& limits) {
  using enum Parameter;
  Grown grown;
  const Values values(request.parameters, grown.notes);
  const Profile profile = profile_of(values);
  const bool asked = request.m != 0 || !request.n.empty();
  auto shape = asked ? asked_shape(request, profile) : Result<Shape>(shape_of(profile, values[fit]));
  if (!shape) return shape.error();

  const std::string_view grammar = request.grammar.empty() ? builtin_grammar(3) : request.grammar;
  const auto first = derive_stock(grammar, request.seed, shape.value(), values, limits);
  if (!first) return first.error();
  grown.plan = std::move(shape->plan);

  std::optional<Stock> second;
  if (values[wing] > 0) {
    Shape smaller = shape_of(scaled(profile, values[wing]), values[fit]);
    const std::uint64_t seed = hash_combine(request.seed, hash_text("second bunch"));
    auto stock = derive_stock(grammar, seed, smaller, values, limits);
    if (!stock) return stock.error();
    second = std::move(stock.value());
    second->first_axis = grown.plan.m - 1;
    second->lean = values[wing_angle];
    grown.second = std::move(smaller.plan);
  }

  const InteractionOptions interaction{values[delta], static_cast<std::uint32_t>(values[t]), values[sag]};
  Growth growth(interaction, limits, std::max(values[rmin], values[rmax]));
  const Diagnostic trouble = interpret_all(first.value(), second ? &*second : nullptr, limits, growth);
  if (trouble.reason != Reason::none) return trouble;
  remark(*first->program, values.defines(), growth, grown.notes);

  to_metres(growth.internodes, growth.berries, values[unit] * metres_per_millimetre);
  grown.internodes = std::move(growth.internodes);
  grown.berries = std::move(growth.berries);
  for (const Berry& berry : grown.berries) grown.traits.push_back({2 * berry.radius, 2 * berry.radius});
  grown.counts = counted(grown, growth.cuts);
  grown.fingerprint = fingerprint(grown);
  if (request.meshes) add_meshes(grown, request);
  return grown;
}

}  // namespace panicle::bunch
