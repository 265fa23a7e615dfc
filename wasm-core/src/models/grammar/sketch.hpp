// A drawing of a grammar with the module and the colour of each line, organ and polygon.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem_plant/drawing.hpp"

namespace panicle::grammar {

// Marks an unset width: the turtle begins with it, and lines that still have it get the model's own width (girth.hpp).
inline constexpr float no_width = 1e-30f;
// Number of colours of a document's palette.
inline constexpr std::uint8_t colours = 8;
// Tags of organs: a ball, a polygon, then the surfaces in their order (surfaces.hpp).
inline constexpr std::uint32_t ball_tag = 0, polygon_tag = 1, first_surface_tag = 2;

// Sides of a ball, and of each ball where there are very many.
inline constexpr std::uint32_t ball_segments = 16, many_ball_segments = 8;

// The module and the colour of a line, an organ or a polygon.
struct Mark {
  std::uint32_t module = 0;  // index in the last string
  std::uint8_t colour = 1;   // 1 … colours
};

// An organ in the turtle's frame.
struct SketchOrgan {
  std::uint32_t tag = 0;
  std::int32_t segment = -1;  // index of the segment that it is attached to; −1 for none
  glm::vec3 place{0};
  glm::mat3 frame{1};  // x to the turtle's right, y along its heading, z to its upper side
  float size = 1;      // radius of a ball
  Mark mark;
};

struct Polygon {
  std::uint32_t first = 0, count = 0;  // first corner and number of corners
  std::uint32_t organ = 0;             // index of its organ
  float thickness = 0;                 // 0: a sheet
  Mark mark;
};

struct Polygons {
  std::vector<Polygon> all;
  std::vector<glm::vec3> corners;
};

// The drawing. A limit that is reached ends the drawing and not the plant: `trouble` describes the limit.
class Sketch final : public Drawing {
 public:
  explicit Sketch(const Limits& limits);

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;
  void sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override;
  void polygon(const lsystem::Turtle& turtle, std::span<const glm::vec3> corners,
               const lsystem::Lineage& lineage) override;
  void plate(const lsystem::Turtle& turtle, std::span<const glm::vec3> corners, float thickness,
             const lsystem::Lineage& lineage) override;
  void surface(const lsystem::Turtle& turtle, std::string_view name, float size,
               const lsystem::Lineage& lineage) override;
  void disc(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override;
  void note(std::string_view note) override { notes.emplace_back(note); }

  std::vector<Mark> lines;          // one a segment
  std::vector<SketchOrgan> organs;  // in the order of the string
  Polygons polygons;
  std::vector<std::string> notes;

 private:
  std::vector<std::uint64_t> bytes_;            // bytes in a file of one organ of each tag
  std::set<std::string, std::less<>> unknown_;  // names of unknown surfaces
  // Takes `bytes` of the file's limit. Returns false and sets `trouble` where fewer are left.
  bool has_room(std::uint64_t bytes);
  // Whether another organ of a tag is within the limits; if not, `trouble` is set.
  bool can_add_organ(std::uint32_t tag);
  void add_organ(std::uint32_t tag, const lsystem::Turtle& turtle, float size, std::uint8_t natural,
                 const lsystem::Lineage& lineage);
};

}  // namespace panicle::grammar
