// The cache of the flower model changes nothing but time: in any order of requests, each response equals that of a
// model without a cache. And a skin is as thick as the text sets.
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "flowers.hpp"
#include "foundation/english.hpp"
#include "foundation/random.hpp"
#include "models/flower/model.hpp"
#include "models/flower/skin.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

struct FlowerRequest {
  std::string text;
  float age = 1, smooth = 1;
  std::uint32_t seed = 1;
  std::string outputs = "meshes";
  std::string names = "";
  std::vector<float> values = {};
};

Result<Plant> grow_flower(const FlowerRequest& wanted, CacheSlot* cache) {
  const std::string name = "flower";
  const std::vector<float> parameters = {0, wanted.age, wanted.smooth};
  const std::vector<std::uint32_t> seed = {wanted.seed};
  const auto view = [](std::string_view block, const auto& values) {
    using Value = std::remove_cvref_t<decltype(values[0])>;
    return ColumnView{block, element_of<Value>(), 1, static_cast<std::uint32_t>(values.size()),
                      reinterpret_cast<const std::uint8_t*>(values.data())};
  };
  const std::vector<ColumnView> blocks{view("model", name),          view("outputs", wanted.outputs),
                                       view("text", wanted.text),    view("parameters", parameters),
                                       view("seed", seed),           view("values.names", wanted.names),
                                       view("values", wanted.values)};
  Request request(blocks, nullptr, cache);
  return model.grow(request, Limits{});
}

// All parts of a response as text; or the message of an error.
std::string answer(const FlowerRequest& wanted, CacheSlot* cache) {
  const auto grown = grow_flower(wanted, cache);
  if (!grown) return english(grown.error().message) + std::to_string(grown.error().line);
  std::string all = std::to_string(grown->fingerprint);
  const auto add = [&](const void* data, std::size_t bytes) {
    all.append(static_cast<const char*>(data), bytes).append(";");
  };
  const auto add_columns = [&](const Columns& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      all.append(columns[i].name);
      add(columns[i].data, columns[i].bytes());
    }
  };
  for (const std::string& note : grown->notes) all.append(note);
  for (const float measure : grown->measures) add(&measure, sizeof measure);
  add_columns(grown->columns);
  for (const PlantMesh& mesh : grown->meshes) {
    all.append(mesh.name).append(mesh.material);
    for (const auto* values : {&mesh.mesh.positions, &mesh.mesh.normals, &mesh.mesh.uvs})
      add(values->data(), 4 * values->size());
    add(mesh.mesh.indices.data(), 4 * mesh.mesh.indices.size());
    add_columns(mesh.columns);
  }
  return all;
}

// Ranges of the figures in a text.
std::vector<std::pair<std::size_t, std::size_t>> figures(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t i = text.find("#define"); i < text.size(); ++i) {
    if (!is_digit(i) || std::isalnum(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == '.') continue;
    std::size_t end = i;
    while (is_digit(end) || (end < text.size() && text[end] == '.')) ++end;
    found.push_back({i, end});
    i = end;
  }
  return found;
}

// The skin of a vertical tube.
Mesh tube(std::uint32_t sides, float diameter, std::uint32_t rounds) {
  const std::string n = std::to_string(sides), d = std::to_string(diameter);
  const Flower flower =
      grown("#define A(" + n + ",0,0,0,4," + d + "," + d + ",1)\n#axiom: A\nA -> A[A]_{E}\n", steps(9));
  generalized_map::Embedding embedding;
  embedding.build(flower.derived.map);
  Skin skin(flower.derived, embedding, rounds);
  embedding.place(skin.shapes(flower.derived));
  Plant plant;
  skin.add_to(plant, flower.program, flower.derived, embedding, false);
  return plant.meshes.at(0).mesh;
}

// How far a tube's skin is from the axis at half its height, in millimetres.
double radius_of(std::uint32_t sides, float diameter, std::uint32_t rounds) {
  const std::vector<float> at = tube(sides, diameter, rounds).positions;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < at.size(); i += 3) {
    if (at[i + 1] < 0.012f || at[i + 1] > 0.028f) continue;
    sum += std::sqrt(at[i] * at[i] + at[i + 2] * at[i + 2]);
    ++count;
  }
  return 1000 * sum / static_cast<double>(count);
}

}  // namespace

TEST_CASE("responses with a cache equal responses without one") {
  std::uint64_t draw = 0;
  const auto drawn = [&](std::size_t below) {
    return static_cast<std::size_t>(random_integer(7, 1, ++draw, 0, static_cast<std::int32_t>(below) - 1));
  };
  std::size_t changed = 0;
  // Its map depends on random values and on the age.
  const std::string random_map =
      "#define A(4,0,0,0,2,2,2,1)\n#axiom: A\nA{}{math.random(0,1) < 0.5}{} -> A[A]_{C1}\n"
      "A{}{step < 8*age}{} -> A[A(,<math.random(0,9)>)]_{E}";
  for (const char* name : {"table-3", "figure-16", "petal", "lucky"}) {
    CacheSlot cache;
    const std::string whole = std::string_view(name) == "lucky" ? random_map : text_named(name);
    const auto all = figures(whole);
    FlowerRequest wanted{whole};
    std::string before = answer(wanted, &cache);
    for (int i = 0; i < 60; ++i) {
      // Mostly changes a figure of the text, sometimes a parameter, and back.
      switch (drawn(9)) {
        case 0:
          wanted.text = whole;
          wanted.seed = static_cast<std::uint32_t>(1 + drawn(2));
          break;
        case 1:
          wanted.age = static_cast<float>(drawn(3));
          break;
        case 2:
          wanted.smooth = static_cast<float>(drawn(3));
          break;
        case 3: {
          const std::size_t at = drawn(3);
          wanted.names = std::vector<std::string>{"", "rd", "rd nothing"}[at];
          wanted.values = std::vector<std::vector<float>>{{}, {static_cast<float>(drawn(9))}, {3, 4}}[at];
          break;
        }
        case 4:
          wanted.outputs =
              std::vector<std::string>{"meshes sky measures map", "measures", "levels", "levels measures"}[drawn(4)];
          break;
        default: {
          const auto [from, to] = all[drawn(all.size())];
          wanted.text = whole;
          wanted.text.replace(from, to - from, std::to_string(drawn(9)) + (drawn(2) == 0 ? ".5" : ""));
        }
      }
      CAPTURE(name);
      CAPTURE(i);
      const std::string again = answer(wanted, &cache);
      REQUIRE((again == answer(wanted, nullptr)));
      changed += again != before;
      before = again;
    }
  }
  CHECK(changed > 100);
}

TEST_CASE("a request's values replace those of variables, and a note lists unknown names") {
  const std::string text =
      "#define k=3\n#define own=1\n#define A(4,0,0,0,k,2,2,1)\n#axiom: A\n#module M\n#define j=1\n"
      "#define B(4)\n#axiom: B";
  const auto grown = [&](const std::string& names, std::vector<float> values) {
    return sound(grow_flower({text, 1, 1, 1, "measures", names, std::move(values)}, nullptr));
  };
  CHECK(grown("", {}).measures[0] == doctest::Approx(0.3));
  CHECK(grown("own k", {1, 8}).measures[0] == doctest::Approx(0.8));
  const Plant strange = grown("k j", {8, 5});
  CHECK(strange.measures[0] == doctest::Approx(0.8));
  REQUIRE(strange.notes.size() == grown("k", {8}).notes.size() + 1);
  CHECK(english(strange.notes.back()) ==
        "The grammar has no “#define” for j, so these values have no effect. It defines k, own.");
  std::string many, strangers;
  std::vector<float> values;
  for (int i = 0; i < 300; ++i) {
    const std::string name = std::string(500, 'v') + std::to_string(i);
    many += "#define " + name + "=1\n";
    strangers += (i == 0 ? "u" : " u") + std::to_string(i);
    values.push_back(1);
  }
  const std::string note =
      english(sound(grow_flower({many + text, 1, 1, 1, "measures", strangers, values}, nullptr)).notes.back());
  CHECK(note.find("u0, u1, u2") != std::string::npos);
  CHECK(note.find(" and 288 more, so") != std::string::npos);
  CHECK(note.size() < 2000);
}

TEST_CASE("an m that is not a material's number has a note with the line that gives it") {
  const auto noted = [](const std::string& text, std::string_view words) {
    const Plant plant = sound(grow_flower({text}, nullptr));
    return std::any_of(plant.notes.begin(), plant.notes.end(),
                       [&](const std::string& note) { return english(note).find(words) != std::string::npos; });
  };
  const std::string rest = "\n#define B(4,0,0,0,2,2,2,1)\n#axiom: A\n#define finalStep=4\n";
  CHECK(noted("#define A(4,0,0,0,2,2,2,999)" + rest + "A -> A[A]_{E}", "Line 1: “A” has m = 999; a material number"));
  CHECK(noted("#define A(4,0,0,0,2,2,2,1)" + rest + "A{}{step==1}{} -> A[B(,,,,,,,1.5)]_{E}\nB -> B[B]_{E}",
              "Line 5: “B” has m = 1.5"));
  CHECK(noted("#define A(4,0,0,0,2,2,2,1)" + rest + "A -E-> B(,,,,,,,300) B", "Line 5: “B” has m = 300"));
  CHECK(noted("#define A(4,0,0,0,2,2,2,1)\n#axiom: A(,,,,,,,300)", "Line 2: “A” has m = 300"));
  CHECK(noted("#define A(4,0,0,0,2,2,2,1)" + rest +
                  "A{}{step==0}{} -> A[&M]_{E}\n#module M\n#define B(4,0,0,0,2,2,2,1)\n"
                  "#axiom: B(,,,,,,,300)",
              "Line 8: “B” has m = 300"));
  CHECK_FALSE(noted("#define A(4,0,0,0,2,2,2,255)" + rest + "A -> A[A]_{E}", "has m ="));
}

TEST_CASE("the structure key excludes figures that only place the map") {
  const auto same = [](std::string_view a, std::string_view b) { return same_map(program_of(a), program_of(b)); };
  const std::string text =
      "#define k=3\n#define n=5\n#define A(n,0,0,0,1,2,k,1)\n#axiom: A(, 4)\n#define finalStep=6\n"
      "A{w=2;u=3}{step<w}{} -> A[A(,<u*5>)]_{E}\nA{v=7}{step<4}{} -> A[B(,,v)]_{C(1+1)}\n#define B(4,0,0,0,1,1,1,1)\n"
      "#material 1 stem \"112233\"";
  const auto with = [&](std::string_view from, std::string_view to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return other;
  };
  CHECK(same(text, text));
  for (const auto& [from, to] : std::vector<std::pair<std::string_view, std::string_view>>{
           {"k=3", "k=3.25"}, {"0,1,2,k", "9,1,2,k"}, {"(, 4)", "(, 5)"}, {"v=7", "v=8"}, {"112233", "445566"}})
    CHECK_MESSAGE(same(text, with(from, to)), from);
  // Orders, conditions, figures that those depend on, faces, steps, lines, names, and changes of more than a figure.
  for (const auto& [from, to] : std::vector<std::pair<std::string_view, std::string_view>>{{"n=5", "n=6"},
                                                                                           {"w=2", "w=3"},
                                                                                           {"u=3", "u=4"},
                                                                                           {"<4}", "<5}"},
                                                                                           {"1+1", "1+2"},
                                                                                           {"Step=6", "Step=7"},
                                                                                           {"B(4,", "B(5,"},
                                                                                           {"#axiom", "\n#axiom"},
                                                                                           {"k=3", "k=-3"},
                                                                                           {"k=3", "k=2+1"}})
    CHECK_FALSE_MESSAGE(same(text, with(from, to)), from);
  // The value of a call depends on the blocks of its own production alone: other lists of the line may have figures.
  const std::string line =
      "#define k=3\n#define A(4,0,0,0,1,1,1,1)\n#axiom: A\n"
      "A{q=step/2}{step<3}{} -> A[A(,,,,k,,,)]_{E}[&M{n=4+q}]_{C1}\n#module M\n#define n=4\n#define B(n)\n#axiom: B\n";
  CHECK(same(line, "#define k=5" + line.substr(11)));
  // Nor are variables, whose code counts as work: equal terms are compiled once.
  const std::string twice = "#define k=age*3+age*3\n#define A(4)\n#axiom: A";
  CHECK(same(twice, twice));
  CHECK_FALSE(same(twice, "#define k=age*3+age*4\n#define A(4)\n#axiom: A"));
  const std::string module =
      "#define A(4,0,0,0,1,1,1,1)\n#axiom: A\nA -> A[&M{n=5; l=2}]_{E}\n#module M\n#define n=4\n#define l=1\n"
      "#define A(n,0,0,0,l,1,1,1)\n#axiom: A\n";
  const auto called = [&](std::string_view from, std::string_view to) {
    std::string other = module;
    for (std::size_t at = other.find(from); at != std::string::npos; at = other.find(from, at + to.size()))
      other.replace(at, from.size(), to);
    return other;
  };
  CHECK(same(module, called("l=2", "l=3")));
  CHECK_FALSE(same(module, called("n=5", "n=6")));
  CHECK_FALSE(same(module, called("M", "N")));
}

TEST_CASE("a tube's skin has the text's thickness for any number of sides") {
  for (const std::uint32_t sides : {4u, 5u, 6u, 8u, 12u, 21u})
    for (const std::uint32_t rounds : {1u, 2u, 3u}) {
      CAPTURE(sides);
      CAPTURE(rounds);
      CHECK(radius_of(sides, 6, rounds) == doctest::Approx(3).epsilon(0.01));
    }
}

TEST_CASE("a skin that would have too many triangles is rounded less often, with a note") {
  // Forty thousand prisms of three sides: more than half a million triangles when they are rounded once.
  const std::string many =
      "#define A(4)\n#define B(5)\n#axiom: A\n#define finalStep=400\nA -> A[A]_{E}[&M]_{C1}\n#module M\n"
      "#define B(3)\n#axiom: B\n#define finalStep=100\nB -> B[B]_{E}";
  const auto wanted = [&](float smooth) {
    FlowerRequest one{many};
    one.smooth = smooth;
    return sound(grow_flower(one, nullptr));
  };
  const auto count = [](const Plant& plant) {
    std::size_t triangles = 0;
    for (const PlantMesh& mesh : plant.meshes) triangles += mesh.mesh.indices.size() / 3;
    return triangles;
  };
  const Plant once = wanted(1), thrice = wanted(3);
  CHECK(count(once) > 500'000);
  CHECK(count(thrice) <= Skin::max_triangles);
  CHECK(count(thrice) == 4 * count(once));
  CHECK(once.notes.size() + 1 == thrice.notes.size());
  CHECK(english(thrice.notes.back()).find("rounded 2 times instead of 3, because of the limit of 4000000 triangles") !=
        std::string::npos);
}

TEST_CASE("a skin faces outwards") {
  const Mesh mesh = tube(6, 5, 1);
  const auto corner = [&](std::size_t i) {
    const float* const at = &mesh.positions[3 * mesh.indices[i]];
    return glm::vec3(at[0], at[1], at[2]);
  };
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    volume += static_cast<double>(glm::dot(corner(i), glm::cross(corner(i + 1), corner(i + 2)))) / 6;
  // A tube of 36 by 5 mm, rounded at its ends.
  CHECK(1e9 * volume > 500);
  CHECK(1e9 * volume < 900);
}

// The line of each column: name, type, and its width where that is not 1.
TEST_CASE("model.hpp documents all columns") {
  const FlowerRequest wanted{.text = text_named("table-3"), .outputs = "meshes"};
  const Plant plant = sound(grow_flower(wanted, nullptr));
  const std::string page = content(panicle::tests::repository_folder() + "/wasm-core/src/models/flower/model.hpp");
  std::size_t wide = 0;
  for (std::size_t i = 0; i < plant.columns.size(); ++i) {
    const std::string name(plant.columns[i].name);
    CAPTURE(name);
    const std::size_t at = page.find("//   " + name);
    if (name == "labels") continue;
    REQUIRE(at != std::string::npos);
    const std::string line = page.substr(at, page.find('\n', at) - at);
    const std::string times = "32 × " + std::to_string(plant.columns[i].width);
    CHECK((line.find(times) != std::string::npos) == (plant.columns[i].width > 1));
    wide += plant.columns[i].width > 1;
  }
  CHECK(wide == 3);
}
