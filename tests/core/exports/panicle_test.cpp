#include "exports/panicle.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/container.hpp"
#include "foundation/english.hpp"
#include "foundation/random.hpp"
#include "foundation/result.hpp"
#include "models/bunch/parameters.generated.hpp"
#include "protocol/answer.hpp"
#include "protocol/compiled_texts.hpp"

using namespace panicle;

namespace {

// A request as a page writes it; blocks may be added before it is sent.
struct TestRequest {
  explicit TestRequest(std::string_view outputs = "", std::string_view model = "bunch") {
    writer.add("model", model);
    writer.add("outputs", outputs);
  }
  ContainerWriter writer;
};

struct Answer {
  explicit Answer(const TestRequest& request) {
    std::uint8_t* const block_of_request = request.writer.write();
    send({block_of_request, container_bytes(block_of_request)});
    std::free(block_of_request);
  }
  explicit Answer(std::span<const std::uint8_t> bytes) { send(bytes); }
  explicit Answer(std::uint8_t* answer) { take(answer); }
  ~Answer() { panicle_release(block); }
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;

  const ColumnView* find(std::string_view name) const {
    for (const ColumnView& column : columns)
      if (column.name == name) return &column;
    return nullptr;
  }
  const ColumnView& column(std::string_view name) const {
    const ColumnView* const found = find(name);
    REQUIRE_MESSAGE(found != nullptr, name);
    return *found;
  }
  std::uint32_t rows(std::string_view name) const { return column(name).rows; }
  std::uint32_t word(std::string_view name, std::size_t index) const { return column(name).as<std::uint32_t>()[index]; }
  Reason reason() const { return static_cast<Reason>(word("status", 0)); }
  std::string message() const { return english(column("message").text()); }

  std::uint8_t* block = nullptr;
  std::vector<ColumnView> columns;

 private:
  void send(std::span<const std::uint8_t> bytes) {
    take(panicle_grow(bytes.data(), static_cast<std::uint32_t>(bytes.size())));
  }
  void take(std::uint8_t* answer) {
    block = answer;
    REQUIRE(block != nullptr);
    auto read = read_container({block, container_bytes(block)});
    REQUIRE(read);
    columns = read.value();
  }
};

}  // namespace

TEST_CASE("the smallest request grows the default bunch, column by column") {
  const Answer answer(TestRequest("meshes"));
  REQUIRE(answer.reason() == Reason::none);
  const std::uint32_t internodes = answer.word("counts", 1), berries = answer.word("counts", 3);
  CHECK(answer.column("counts.names").text().substr(0, 25) == "endStructures\ninternodes\n");
  CHECK(answer.column("plan.axes").as<std::int32_t>()[0] == 18);
  CHECK(answer.rows("plan.axes") == 1 + 17);
  CHECK(answer.rows("plan.sides") == 4);
  CHECK(answer.find("second.axes") == nullptr);
  for (const auto name : {"segments.parent", "segments.tag", "segments.ends", "segments.radii", "segments.axis"})
    CHECK(answer.rows(name) == internodes);
  CHECK(answer.column("segments.tags").text() == "rachis\naxis\nend\npedicel");
  for (const auto name : {"berries.spheres", "berries.directions", "berries.parent", "berries.id", "berries.exposure"})
    CHECK(answer.rows(name) == berries);
  const std::uint32_t vertices = answer.rows("mesh.stems.segment");
  CHECK(vertices > 0);
  CHECK(answer.rows("mesh.stems.positions") == vertices);
  CHECK(answer.rows("mesh.stems.normals") == vertices);
  CHECK(answer.rows("mesh.stems.uvs") == vertices);
  CHECK(answer.rows("mesh.stems.runs") == answer.rows("mesh.stems.axis"));
  CHECK(answer.column("mesh.stems.material").text() == "stem");
  CHECK(answer.column("procedure").text() == "natural");
  CHECK(answer.rows("thinned.id") == answer.rows("thinned.places"));
  const std::uint32_t pattern = answer.rows("berries.pattern.uvs");
  CHECK(pattern > 0);
  for (const auto name : {"berries.positions", "berries.normals", "berries.pressed"})
    CHECK(answer.rows(name) == berries * pattern);
  CHECK(answer.column("meshes").text() == "stems");
  CHECK(answer.find("measures") == nullptr);
  CHECK(Answer(TestRequest("measures")).rows("measures") > 0);
}

TEST_CASE("a request may remove berries by their ids") {
  const Answer whole{TestRequest()};
  TestRequest request;
  const std::uint32_t id = whole.word("berries.id", 5);
  request.writer.add("thinned", std::span<const std::uint32_t>(&id, 1));
  const Answer less(request);
  REQUIRE(less.reason() == Reason::none);
  CHECK(less.word("counts", 3) == whole.word("counts", 3) - 1);
}

TEST_CASE("meshes and their fingerprint are made only when requested, and leave the skeleton unchanged") {
  const Answer bare{TestRequest()}, whole(TestRequest("meshes")),
      printed(TestRequest("measures meshes mesh_fingerprint"));
  CHECK(bare.find("mesh.stems.positions") == nullptr);
  CHECK(bare.word("fingerprint", 0) == whole.word("fingerprint", 0));
  CHECK(bare.word("fingerprint", 1) == whole.word("fingerprint", 1));
  CHECK(whole.find("mesh_fingerprint") == nullptr);
  CHECK(printed.word("mesh_fingerprint", 0) != 0);
}

TEST_CASE("an invalid request is an error with a message") {
  const auto refused = [](const Answer& answer, std::string_view word) {
    CHECK(answer.reason() == Reason::bad_request);
    CHECK_MESSAGE(answer.message().find(word) != std::string::npos, answer.message());
  };
  refused(Answer(std::span<const std::uint8_t>()), "shorter");
  const std::vector<std::uint32_t> zeros(10, 0);
  refused(Answer({reinterpret_cast<const std::uint8_t*>(zeros.data()), 40}), "magic");
  refused(Answer(TestRequest("", "grapes")), "model");
  TestRequest unknown;
  unknown.writer.add("thined", std::span<const std::uint32_t>());
  refused(Answer(unknown), "“thined”");
  TestRequest other;
  other.writer.add("seed", "1");
  refused(Answer(other), "“seed”");
  TestRequest many;
  const std::vector<float> numbers(200'000, 0.0f);
  many.writer.add("parameters", numbers);
  refused(Answer(many), "too many values");
  TestRequest wide;
  const std::vector<float> rows(150'000, 0.0f);
  wide.writer.add("parameters", rows, 3);
  refused(Answer(wide), "too many values");
}

TEST_CASE("a compiled grammar grows the same plant as its text") {
  const std::string_view text = "axiom: F(40)[+(60)F(30)S(9)]S(12)";
  TestRequest spelled;
  spelled.writer.add("grammar", text);
  const Answer compiled(panicle_compile(text.data(), static_cast<std::uint32_t>(text.size())));
  REQUIRE(compiled.reason() == Reason::none);
  const std::uint32_t handle = compiled.word("program", 0);
  TestRequest named;
  named.writer.add("program", std::span<const std::uint32_t>(&handle, 1));
  const Answer one(spelled), other(named);
  REQUIRE(other.reason() == Reason::none);
  CHECK(one.word("fingerprint", 0) == other.word("fingerprint", 0));
  CHECK(one.word("counts", 1) == other.word("counts", 1));
  panicle_forget(handle);
  const Answer forgotten(named);
  CHECK(forgotten.reason() == Reason::bad_request);
  CHECK(forgotten.message().find("not stored") != std::string::npos);
  const Answer wrong(panicle_compile("axiom: F(", 9));
  CHECK(wrong.reason() == Reason::syntax);
  CHECK(wrong.word("status", 1) == 1);
  CHECK(wrong.word("status", 2) == 10);
}

TEST_CASE("segments begin where their parents end, and have a length and two radii") {
  const Answer answer{TestRequest()};
  const auto parents = answer.column("segments.parent").as<std::int32_t>();
  const auto ends = answer.column("segments.ends").as<float>(), radii = answer.column("segments.radii").as<float>();
  REQUIRE(ends.size() == 6 * parents.size());
  bool tapers = false;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) {
      same &= ends[6 * i + k] == ends[6 * i + 3 + k];
      if (parents[i] >= 0) CHECK(ends[6 * i + k] == ends[6 * static_cast<std::size_t>(parents[i]) + 3 + k]);
    }
    CHECK(!same);
    tapers |= radii[2 * i] != radii[2 * i + 1];
  }
  CHECK(tapers);
}

TEST_CASE("segments and organs have their own tags") {
  Plant plant;
  for (std::uint32_t i = 0; i < 300; ++i) {
    plant.tags.push_back("V" + std::to_string(i));
    plant.organ_tags.push_back("leaf" + std::to_string(i));
    plant.segments.push_back({});
    plant.segments.back().tag = i;
    plant.organs.push_back({});
    plant.organs.back().tag = 299 - i;
  }
  const Answer answer(write_plant(plant));
  for (std::uint32_t i = 0; i < 300; ++i) {
    CHECK(answer.word("segments.tag", i) == i);
    CHECK(answer.word("organs.tag", i) == 299 - i);
  }
  CHECK(answer.column("segments.tags").text().ends_with("V299"));
  CHECK(answer.column("organs.tags").text().ends_with("leaf299"));
}

TEST_CASE("check_geometry names the part of a plant whose geometry is not finite") {
  // Every model's own way: nothing before the boundary refuses a stem so thick.
  const auto grown = [](std::string_view model, std::string_view text) {
    TestRequest request("meshes", model);
    request.writer.add("grammar", text);
    return Answer(request);
  };
  for (const std::string_view text :
       {"axiom: F(1e37)F(1e37)F(1e37)", "axiom: @Di(1e38)@Di(1e38)@O(1)", "axiom: @Di(1e38)@Di(1e38)~leaf",
        "axiom: !(1e38)F(1e30)S(1e38)", "axiom: !(1e38)F(1)"}) {
    const Answer answer = grown("grammar", text);
    CAPTURE(text);
    CHECK(answer.reason() == Reason::evaluation);
    CHECK(answer.message().find("Module ") == 0);
  }
  CHECK(grown("bunch", "axiom: F(1e37)S(1e38)").reason() == Reason::evaluation);
  CHECK(grown("grammar", "axiom: F(1)@O(1)").reason() == Reason::none);
}

TEST_CASE("a request gets its memory up to 16 MiB") {
  for (const std::uint32_t bytes : {0u, 1u, 16u * 1024 * 1024}) {
    void* const memory = panicle_allocate(bytes);
    CHECK(memory != nullptr);
    panicle_release(memory);
  }
  CHECK(panicle_allocate(16u * 1024 * 1024 + 1) == nullptr);
  CHECK(panicle_allocate(0xffffffffu) == nullptr);
}

TEST_CASE("a request may set the steps of a text; else the text does, else it is derived to its end") {
  // A text grows below its peduncle, which is no part of it.
  std::vector<float> parameters;
  for (const ParameterInfo& each : bunch::parameter_table) parameters.push_back(each.standard);
  parameters[static_cast<std::size_t>(bunch::Parameter::peduncle)] = 0;
  const auto internodes = [&parameters](std::string_view text, int steps) {
    TestRequest request;
    request.writer.add("parameters", std::span<const float>(parameters));
    request.writer.add("grammar", text);
    const auto number = static_cast<std::uint32_t>(steps);
    if (steps >= 0) request.writer.add("steps", std::span<const std::uint32_t>(&number, 1));
    const Answer answer(request);
    REQUIRE_MESSAGE(answer.reason() == Reason::none, answer.message());
    return answer.word("counts", 1);
  };
  const std::string_view endless = "axiom: A\nA --> F(9) A", ending = "axiom: A(5)\nA(n) : n>0 --> F(9) A(n-1)";
  CHECK(internodes(endless, 3) == 3);
  CHECK(internodes(ending, 2) == 2);
  CHECK(internodes(ending, -1) == 5);
  CHECK(internodes("derivation length: 4\naxiom: A\nA --> F(9) A", -1) == 4);
  CHECK(internodes("derivation length: 4\naxiom: A\nA --> F(9) A", 1) == 1);
}

TEST_CASE("compiled grammars are stored up to a limit, with an error beyond") {
  std::vector<std::uint32_t> handles;
  for (std::size_t i = 0; i < CompiledTexts::most; ++i)
    handles.push_back(Answer(panicle_compile("axiom: F", 8)).word("program", 0));
  CHECK(Answer(panicle_compile("axiom: F", 8)).reason() == Reason::limit);
  for (const std::uint32_t handle : handles) panicle_forget(handle);
  const Answer again(panicle_compile("axiom: F", 8));
  REQUIRE(again.reason() == Reason::none);
  CHECK(again.word("program", 0) > handles.back());
  panicle_forget(again.word("program", 0));
}

TEST_CASE("random bytes of a request are an error or a plant, without crashes") {
  std::vector<std::uint32_t> parameters(bunch::parameter_count);
  for (std::uint64_t round = 0; round < 300; ++round) {
    for (std::size_t i = 0; i < parameters.size(); ++i)
      parameters[i] = static_cast<std::uint32_t>(random_bits(round, 1, i));
    TestRequest request;
    request.writer.add("parameters", std::span(reinterpret_cast<const float*>(parameters.data()), parameters.size()));
    if (round % 2) request.writer.add("grammar", "axiom: F(1)S(2)\nF(x) --> F(x)[+F(x/2)]");
    std::uint8_t* const block = request.writer.write();
    const std::uint32_t bytes = container_bytes(block);
    // One byte of header, directory, names or data is another one.
    const auto at = static_cast<std::uint32_t>(random_bits(round, 2, 0) % bytes);
    block[at] = static_cast<std::uint8_t>(random_bits(round, 3, 0));
    const Answer answer({block, bytes - static_cast<std::uint32_t>(round % 3)});
    CHECK(answer.rows("status") == 3);
    std::free(block);
  }
}

TEST_CASE("a response has each note once, though the derivation and the drawing reach the same limit") {
  TestRequest request("", "grammar");
  request.writer.add("grammar", std::string_view("#turtle cpfg\nderivation length: 4096\naxiom: A(13)\n"
                                                 "A(n) : n>0 --> A(n-1) A(n-1)\nA(n) : n==0 --> A(0)\n"
                                                 "homomorphism\nmaximum depth: 256\nA(n) --> f A(n) f A(n)\n"));
  const Answer answer(request);
  REQUIRE(answer.reason() == Reason::none);
  const std::string notes = english(answer.column("notes").text());
  const std::string limit = "The plant is shown as far as it has grown. The grammar exceeds the limit of ";
  CHECK(notes.starts_with(limit));
  CHECK(notes.find(limit, 1) == std::string::npos);
  CHECK(answer.word("cut_short", 0) == 1);
}
