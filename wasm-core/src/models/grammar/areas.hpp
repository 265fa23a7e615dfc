// Growth areas (Seo et al. 2014: clipping volumes): what a text asks by bound() and reach(), and what it is told of
// them.
//
// Blocks of a request, all in metres and absent where there is nothing of them:
//   areas.kinds      uint32: Volume::Kind of each
//   areas.places     float32, 10 each: centre, full size, rotation (unit quaternion x y z w)
//   areas.meshes     uint32, 2 each: how many points and triangles of the two blocks below are its own
//   areas.points     float32, 3 each
//   areas.triangles  uint32, 3 each: corners, counted from the first of the area's own points
//   path             float32, 3 each: places that the main branch is led by; where absent, the centres
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

// Areas are counted from 1.
class Areas final : public expression::Space {
 public:
  static constexpr std::size_t most_areas = 64, most_places = 1000;

  // Errors: bad_request, for what is of another form; bad_input, for numbers that are not finite or beyond 10 km, or a
  // corner that is none of the mesh's points; limit, for too many triangles. Notes on the meshes follow with
  // `tell`.
  static Result<Areas> read(Request& request, const Limits& limits);

  // What a text may declare: `#input areas` (how many), `#input size[]` (the largest extent of each), `#input places`
  // and `#input path[]` (x, y, z of each place), in its own unit, of which `metres` are one. It is asked in that unit
  // from now on. Of a main branch that forks: `#input forks` (how many branches begin beside another), and of each
  // place `#input next[]` (the place after it, `places` + 1 at an end), `#input fork[]` (the next one of those that
  // come from the same place, 0 for none) and `#input own[]` (the area that the way from there comes to first, 1 where
  // to none).
  void add_inputs(lsystem::Inputs& inputs, float metres);

  bool bound(const glm::vec3& place, float area) const override;
  float reach(const glm::vec3& from, const glm::vec3& way, float area, float most) const override;

  std::size_t size() const { return volumes_.size(); }
  // Whether the meshes have used up their budget: then no place lies in an area that is a mesh.
  bool is_exhausted() const { return budget_->is_exhausted(); }
  // The first area before this one that its middle lies in; 0 for none.
  std::size_t around(std::size_t area) const;
  // What area number i, counted from 0, encloses (m³; of a mesh what its triangles do, by their turn), and its surface.
  double volume(std::size_t i) const;
  Surface surface(std::size_t i) const;
  // Of meshes with gaps or triangles turned against each other, a sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  // As it was asked for.
  struct Form {
    Volume::Kind kind;
    glm::vec3 centre, size;
    glm::quat rotation;
    Surface mesh;
  };

  const Volume* find(float area) const;
  void add_fork_inputs(lsystem::Inputs& inputs) const;

  std::shared_ptr<QueryBudget> budget_;  // of all meshes
  std::vector<Form> forms_;
  std::vector<Volume> volumes_;
  std::vector<glm::vec3> path_;
  std::vector<std::uint32_t> from_;  // of each place, counted from 1
  std::vector<std::string> notes_;
  float metres_ = 1;
};

}  // namespace panicle::grammar
