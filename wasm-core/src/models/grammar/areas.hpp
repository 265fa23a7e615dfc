// Growth areas (Seo et al. 2014: clipping volumes) that grammars query by bound() and reach(), and their `#input`
// values.
//
// Blocks of a request, all in metres; absent where there are none:
//   areas.kinds      uint32: Volume::Kind of each
//   areas.places     float32, 10 each: centre, full size, rotation (unit quaternion x y z w)
//   areas.meshes     uint32, 2 each: the numbers of points and triangles that the mesh takes from the two blocks below
//   areas.points     float32, 3 each
//   areas.triangles  uint32, 3 each: corners, counted from the first of the area's own points
//   path             float32, 3 each: places on the main branch's path; where absent, the centres
//   path.from        uint32, one a place: the earlier place, counted from 1, that the branch comes from; 0, the
//                    foot, for the first place alone. Where absent, the place before it: the branch does not fork
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "expression/space.hpp"
#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "protocol/request.hpp"
#include "spatial/volume.hpp"

namespace panicle::grammar {

// The areas of a request, counted from 1.
class Areas final : public expression::Space {
 public:
  static constexpr std::size_t max_areas = 64, max_places = 1000;

  // Reads the areas of a request. Errors: bad_request, where blocks have wrong lengths; bad_input, for numbers that are
  // not finite or beyond 10 km, or a corner that is none of the mesh's points; limit, for too many triangles. `notes`
  // describes faults of the meshes.
  static Result<Areas> read(Request& request, const Limits& limits);

  // Adds the inputs that a grammar may declare: `#input areas` (their number), `#input size[]` (the largest extent of
  // each), `#input places` and `#input path[]` (x, y, z of each place), in the grammar's unit, which is `metres` long.
  // bound() and reach() are queried in that unit from then on. For a main branch that forks: `#input forks` (the number
  // of branches that begin beside another), and for each place `#input next[]` (the place after it, `places` + 1 at an
  // end), `#input fork[]` (the next place that comes from the same place, 0 for none) and `#input own[]` (the first
  // area on the path from there, 1 where there is none).
  void add_inputs(lsystem::Inputs& inputs, float metres);

  bool bound(const glm::vec3& place, float area) const override;
  float reach(const glm::vec3& from, const glm::vec3& way, float area, float most) const override;

  std::size_t size() const { return volumes_.size(); }
  // Whether the meshes have used up their budget: then no place lies in an area that is a mesh.
  bool is_exhausted() const { return budget_->is_exhausted(); }
  // The first area before this one that contains this one's centre; 0 for none.
  std::size_t around(std::size_t area) const;
  // Volume of area i, counted from 0 (m³; of a mesh the signed volume of its triangles), and its surface.
  double volume(std::size_t i) const;
  Surface surface(std::size_t i) const;
  // A sentence for each mesh with gaps or with triangles turned against each other.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  // An area as requested.
  struct Form {
    Volume::Kind kind;
    glm::vec3 centre, size;
    glm::quat rotation;
    Surface mesh;
  };

  const Volume* find(float area) const;
  void add_fork_inputs(lsystem::Inputs& inputs) const;

  std::shared_ptr<QueryBudget> budget_;  // shared by all meshes
  std::vector<Form> forms_;
  std::vector<Volume> volumes_;
  std::vector<glm::vec3> path_;
  std::vector<std::uint32_t> from_;  // the earlier place of each place, counted from 1
  std::vector<std::string> notes_;
  float metres_ = 1;
};

}  // namespace panicle::grammar
