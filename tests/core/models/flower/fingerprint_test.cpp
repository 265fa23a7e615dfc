// Flowers that differ have different fingerprints, also where they differ only in a lobe beside a vein.
#include "models/flower/fingerprint.hpp"

#include <array>
#include <set>

#include "flowers.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

struct Planted {
  Flower flower;
  generalized_map::Embedding embedding;

  std::uint64_t print() const { return fingerprint_of(flower.derived, embedding); }
  // Of each dart.
  std::vector<glm::vec3> places() const {
    std::vector<glm::vec3> all;
    for (const std::uint32_t vertex : embedding.vertex_of()) all.push_back(embedding.positions()[vertex]);
    return all;
  }
};

Planted planted(const std::string& text) {
  Planted made{grown(text, steps(4)), {}};
  made.embedding.build(made.flower.derived.map);
  made.embedding.place(made.flower.derived.shapes());
  return made;
}

std::uint64_t print_of(const std::string& text) { return planted(text).print(); }

using Figures = std::array<std::string, fields>;
const Figures petal = {"4", "0.1", "2", "3", "4", "5", "6", "7", "1"};

// A vein with a lobe on either side.
std::string blade(const std::string& lobe, const Figures& figures, const std::string& vein_width = "2") {
  std::string all;
  for (const std::string& figure : figures) all.append(all.empty() ? "" : ",").append(figure);
  return "#define V(4,0,0,0,8,4," + vein_width + ",2)\n#define " + lobe + "(" + all +
         ")\n#axiom: V\nV -> V[V]_{E}\nV -> V[" + lobe + "]_{C1, C3}\n";
}

}  // namespace

TEST_CASE("a flower's fingerprint depends on each number of a lobe") {
  std::set<std::uint64_t> prints = {print_of(blade("L", petal))};
  for (std::size_t i = 0; i < fields; ++i) {
    INFO(field_names[i]);
    Figures other = petal;
    other[i] = i == 0 ? "5" : other[i] + "5";
    CHECK(prints.insert(print_of(blade("L", other))).second);
  }
  CHECK(prints.insert(print_of(blade("L", petal, "2.5"))).second);
}

TEST_CASE("a flower's fingerprint depends on places along each axis") {
  const auto box = [](const std::string& sizes) { return print_of("#define A(4,0,0,0," + sizes + ",1)\n#axiom: A\n"); };
  CHECK(std::set{box("5,5,5"), box("6,5,5"), box("5,6,5"), box("5,5,6")}.size() == 4);
}

TEST_CASE("a flower's fingerprint does not depend on names, but on which volumes share a name") {
  CHECK(print_of(blade("L", petal)) == print_of(blade("Lobe", petal)));
  const std::string a = "#define A(4,0,0,0,5,5,5,1)\n", b = "#define B(4,0,0,0,5,5,5,2)\n",
                    rest = "#axiom: A\nA -> A[B]_{E}";
  CHECK(print_of(a + b + rest) == print_of(b + a + rest));
  const std::string one = "#define A(4,0,0,0,5,5,5,1)\n#define B(4,0,0,0,5,5,5,1)\n#axiom: A\n";
  CHECK(print_of(one + "A -> A[A]_{E}") != print_of(one + "A -> A[B]_{E}\nB -> B[B]_{E}"));
}

TEST_CASE("a flower's fingerprint depends on glued faces, also where gluing moves no vertex") {
  // Four cubes about an edge: the last is beside the first only where all have grown on the right sides.
  int moved_nothing = 0;
  for (const char side : std::string("1234"))
    for (const char own : std::string("1234"))
      for (const char other : std::string("1234")) {
        const std::string cubes =
            "#define A(4,0,0,0,5,5,5,1)\n#define B(4,0,0,0,5,5,5,1)\n#define C(4,0,0,0,5,5,5,1)\n"
            "#define D(4,0,0,0,5,5,5,1)\n#axiom: A\nA -> A[B]_{C1}\nA -> A[C]_{C2}\nB -> B[D]_{C" +
            std::string(1, side) + "}\n";
        const Planted apart = planted(cubes);
        const Planted glued =
            planted(cubes + "D: D_C" + own + " < C_C" + other + " -> D_C" + own + " | C_C" + other + "\n");
        const auto free = [](const Planted& of) {
          const auto alpha = of.flower.derived.map.alphas(3);
          std::size_t count = 0;
          for (std::uint32_t d = 0; d < alpha.size(); ++d) count += alpha[d] == d;
          return count;
        };
        if (free(apart) == free(glued) || apart.places() != glued.places()) continue;
        ++moved_nothing;
        CHECK(apart.print() != glued.print());
      }
  CHECK(moved_nothing > 0);
}
