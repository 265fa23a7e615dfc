#include "models/grammar/areas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "models/grammar/messages.generated.hpp"

namespace panicle::grammar {
namespace {

constexpr std::size_t place_width = 10;

// Points and triangles of the request that no mesh has taken yet.
struct MeshData {
  std::span<const float> points;
  std::span<const std::uint32_t> triangles;
};

// Takes the points and triangles of one area from the remaining data. Errors: bad_input.
Result<Surface> take_surface(MeshData& data, std::uint32_t points, std::uint32_t triangles) {
  if (data.points.size() / 3 < points || data.triangles.size() / 3 < triangles)
    return bad_input(message(messages::grammar::area_too_long));
  Surface surface{vectors_of(data.points.first(3 * std::size_t{points})), {}};
  const auto corners = data.triangles.first(3 * std::size_t{triangles});
  for (const std::uint32_t corner : corners)
    if (corner >= points) return bad_input(message(messages::grammar::area_corner));
  surface.triangles.assign(corners.begin(), corners.end());
  data = {data.points.subspan(3 * std::size_t{points}), data.triangles.subspan(3 * std::size_t{triangles})};
  return surface;
}

// The note about a mesh that is no closed surface of even orientation, for area `number`; empty if all is well.
std::string note_about(const Surface& surface, std::size_t number) {
  if (surface.triangles.empty()) return message(messages::grammar::area_empty, number);
  const Seams seams = seams_of(surface);
  if (seams.open > 0) return message(messages::grammar::area_open, number, seams.open);
  if (seams.turned > 0) return message(messages::grammar::area_turned, number, seams.turned);
  return {};
}

// The surface of a volume kind within the box from −1 to 1 on each axis.
Surface surface_in_box(Volume::Kind kind, const Surface& mesh) {
  constexpr std::uint32_t sides = 32;
  constexpr glm::vec2 cylinder[] = {{1, -1}, {1, 1}}, cone[] = {{1, -1}, {0, 1}};
  switch (kind) {
    case Volume::Kind::box:
      return box(glm::vec3(-1), glm::vec3(1));
    case Volume::Kind::cylinder:
      return surface_of_revolution(cylinder, glm::vec3(0), sides);
    case Volume::Kind::cone:
      return surface_of_revolution(cone, glm::vec3(0), sides);
    case Volume::Kind::mesh:
      return stretched(mesh, glm::vec3(-1), glm::vec3(1));
    default:
      return ellipsoid(glm::vec3(0), glm::vec3(1), sides);
  }
}

}  // namespace

// Reads the volumes and the path through them from a request; an error for the first wrong block.
Result<Areas> Areas::read(Request& request, const Limits& limits) {
  const auto kinds = request.words("areas.kinds"), meshes = request.words("areas.meshes");
  const auto places = request.floats("areas.places"), path = request.floats("path");
  const auto from = request.words("path.from");
  MeshData data{request.floats("areas.points"), request.words("areas.triangles")};
  Areas areas;
  // Checks sizes, limits and coordinates before anything is built.
  if (kinds.size() > max_areas || path.size() > 3 * max_places)
    return bad_input(message(messages::grammar::too_many_areas));
  if (places.size() != place_width * kinds.size() || (!meshes.empty() && meshes.size() != 2 * kinds.size()) ||
      path.size() % 3 != 0)
    return bad_request(message(messages::grammar::areas_unpaired));
  if (const auto refusal = too_many_triangles(data.triangles.size() / 3, limits)) return *refusal;
  if (!are_coordinates(places) || !are_coordinates(path) || !are_coordinates(data.points))
    return bad_input(message(messages::grammar::area_not_finite));
  areas.budget_ = std::make_shared<QueryBudget>(limits.looks, kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] > static_cast<std::uint32_t>(Volume::Kind::mesh))
      return bad_input(message(messages::grammar::area_kind));
    const auto kind = static_cast<Volume::Kind>(kinds[i]);
    // A place is 10 numbers: centre, size, and the rotation as x y z w.
    const float* at = &places[place_width * i];
    Surface mesh;
    if (!meshes.empty()) {
      auto taken = take_surface(data, meshes[2 * i], meshes[2 * i + 1]);
      if (!taken) return taken.error();
      mesh = std::move(taken.value());
    }
    if (kind == Volume::Kind::mesh)
      if (std::string note = note_about(mesh, i + 1); !note.empty()) areas.notes_.push_back(std::move(note));
    const glm::vec3 centre(at[0], at[1], at[2]);
    const glm::vec3 size(at[3], at[4], at[5]);
    const glm::quat rotation(at[9], at[6], at[7], at[8]);
    areas.volumes_.emplace_back(kind, centre, size, rotation, mesh, areas.budget_);
    areas.forms_.push_back({kind, centre, size, rotation, std::move(mesh)});
    if (path.empty()) areas.path_.push_back(centre);
  }
  // The path, and for each of its places the one before it, counted from 1; 0 at the start. Without a path it leads
  // through the areas' centres, without `from` from each place to the next.
  if (!path.empty()) areas.path_ = vectors_of(path);
  if (!from.empty() && from.size() != path.size() / 3) return bad_request(message(messages::grammar::path_unpaired));
  for (std::size_t i = 0; i < from.size(); ++i)
    if (from[i] > i || (from[i] == 0 && i > 0)) return bad_input(message(messages::grammar::path_order, i + 1));
  for (std::size_t i = 0; i < areas.path_.size(); ++i)
    areas.from_.push_back(from.empty() ? static_cast<std::uint32_t>(i) : from[i]);
  return areas;
}

// Adds the constants by which a text knows the areas: their number and sizes, and the path. Lengths are divided by
// `metres`, the text's unit.
void Areas::add_inputs(lsystem::Inputs& inputs, float metres) {
  metres_ = metres;
  // Without areas a grammar still has one place to grow towards.
  if (path_.empty()) {
    path_.emplace_back(0, 1, 0);
    from_.push_back(0);
  }
  add_fork_inputs(inputs);
  inputs.scalars.push_back({"areas", static_cast<float>(volumes_.size())});
  inputs.scalars.push_back({"places", static_cast<float>(path_.size())});
  lsystem::Inputs::Array path{"path", {}};
  for (const glm::vec3& place : path_)
    for (int k = 0; k < 3; ++k) path.values.push_back(place[k] / metres);
  inputs.arrays.push_back(std::move(path));
  lsystem::Inputs::Array size{"size", {}};
  for (const Form& form : forms_) {
    const glm::vec3 extent = form.kind == Volume::Kind::sphere ? glm::vec3(form.size.x) : form.size;
    size.values.push_back(std::max({extent.x, extent.y, extent.z}) / metres);
  }
  if (size.values.empty()) size.values.push_back(1 / metres);
  inputs.arrays.push_back(std::move(size));
}

// Adds the inputs that describe the branched path through the areas: for each place, numbered from 1, the next one, the
// one that forks off beside it (0: none) and its area.
void Areas::add_fork_inputs(lsystem::Inputs& inputs) const {
  const std::size_t count = path_.size();
  std::vector<std::uint32_t> next(count, static_cast<std::uint32_t>(count + 1)), fork(count, 0), last(count, 0);
  std::vector<std::uint32_t> own(count, 0);
  std::uint32_t forks = 0;
  for (std::uint32_t i = 1; i < count; ++i) {
    const std::uint32_t place = i + 1, before = from_[i] - 1;
    if (last[before] == 0) {
      next[before] = place;
    } else {
      fork[last[before] - 1] = place;
      ++forks;
    }
    last[before] = place;
  }
  // From the ends to the foot: a place belongs to the area of the first place behind it, unless it lies in an area
  // itself.
  for (std::size_t i = count; i-- > 0;) {
    for (std::uint32_t area = 1; own[i] == 0 && area <= volumes_.size(); ++area)
      if (volumes_[area - 1].contains(path_[i])) own[i] = area;
    if (own[i] == 0 && next[i] <= count) own[i] = own[next[i] - 1];
  }
  inputs.scalars.push_back({"forks", static_cast<float>(forks)});
  const auto add_array = [&inputs](const char* name, const std::vector<std::uint32_t>& values, std::uint32_t least) {
    lsystem::Inputs::Array array{name, {}};
    for (const std::uint32_t value : values) array.values.push_back(static_cast<float>(std::max(value, least)));
    inputs.arrays.push_back(std::move(array));
  };
  add_array("next", next, 0);
  add_array("fork", fork, 0);
  add_array("own", own, 1);
}

// The volume of an area by its number, from 1; null if there is none.
const Volume* Areas::find(float area) const {
  if (!(area >= 1 && area <= static_cast<float>(volumes_.size()))) return nullptr;
  const auto number = static_cast<std::size_t>(area);
  return static_cast<float>(number) == area ? &volumes_[number - 1] : nullptr;
}

// Whether a place, in the text's unit, is inside an area.
bool Areas::bound(const glm::vec3& place, float area) const {
  const Volume* volume = find(area);
  return volume != nullptr && volume->contains(metres_ * place);
}

// The number of the first earlier area that contains the centre of this one; 0 if none does.
std::size_t Areas::around(std::size_t area) const {
  for (std::size_t before = 1; before < area; ++before)
    if (volumes_[before - 1].contains(volumes_[area - 1].centre())) return before;
  return 0;
}

// How far one can go from a place in the direction `way` inside an area, `most` at most; in the text's unit. 0 without
// such an area.
float Areas::reach(const glm::vec3& from, const glm::vec3& way, float area, float most) const {
  const Volume* volume = find(area);
  const float length = glm::length(way);
  if (volume == nullptr || !(length > 0)) return 0;
  // A reach over the whole requested length is returned exactly as requested, since grammars compare the two numbers.
  const float wanted = most * metres_, reached = volume->reach(metres_ * from, way / length, wanted);
  return reached == wanted ? most : reached / metres_;
}

// The volume of area `i`, from 0, in m³: by formula, for a mesh by its signed tetrahedra.
double Areas::volume(std::size_t i) const {
  const Form& form = forms_[i];
  const double x = form.size.x, box = x * form.size.y * form.size.z, turn = static_cast<double>(pi);
  switch (form.kind) {
    case Volume::Kind::box:
      return box;
    case Volume::Kind::sphere:
      return turn / 6 * x * x * x;
    case Volume::Kind::ellipsoid:
      return turn / 6 * box;
    case Volume::Kind::cylinder:
      return turn / 4 * box;
    case Volume::Kind::cone:
      return turn / 12 * box;
    case Volume::Kind::mesh:
      break;
  }
  const Surface made = surface(i);
  double sum = 0;
  for (std::size_t k = 0; k + 2 < made.triangles.size(); k += 3) {
    const auto corner = [&](std::size_t m) {
      return glm::dvec3(made.points[made.triangles[k + m]]) - glm::dvec3(form.centre);
    };
    sum += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
  }
  return std::fabs(sum) / 6;
}

// The surface of area `i`, from 0, as triangles, at its place.
Surface Areas::surface(std::size_t i) const {
  const Form& form = forms_[i];
  Surface made = surface_in_box(form.kind, form.mesh);
  const glm::vec3 half = 0.5f * (form.kind == Volume::Kind::sphere ? glm::vec3(form.size.x) : form.size);
  const float length = std::sqrt(glm::dot(form.rotation, form.rotation));
  const glm::quat turn = length > 0 ? form.rotation / length : glm::quat(1, 0, 0, 0);
  for (glm::vec3& p : made.points) p = form.centre + turn * (half * p);
  return made;
}

}  // namespace panicle::grammar
