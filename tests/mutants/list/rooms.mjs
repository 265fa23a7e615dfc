/** The core's rooms that every model shares. */
const SRC = "wasm-core/src";
const TESTS = "tests/core";

export default [
	{
		file: `${SRC}/foundation/random.hpp`,
		suites: [`${TESTS}/foundation/random_test.cpp`],
		faults: [
			{
				id: "random-half-the-range",
				find: "static_cast<float>(bits >> 8) * 0x1p-24f",
				replace: "static_cast<float>(bits >> 8) * 0x1p-25f",
				breaks: "chance never comes above a half",
			},
		],
	},
	{
		file: `${SRC}/foundation/rotation.hpp`,
		suites: [`${TESTS}/foundation/rotation_test.cpp`],
		faults: [
			{
				id: "rotation-half-turns",
				find: "if (frame[k][k] > frame[i][i]) i = k;",
				replace: ";",
				breaks: "organs turned by half a circle are placed askew",
			},
			{
				id: "rotation-perpendicular-to-itself",
				find: "std::fabs(glm::dot(way, first)) < limit ? first : second",
				replace: "first",
				breaks: "vertical directions have no perpendicular",
			},
		],
	},
	{
		file: `${SRC}/foundation/golden_spiral.hpp`,
		suites: [`${TESTS}/foundation/golden_spiral_test.cpp`],
		faults: [
			{
				id: "golden-disc-crowded-in-the-middle",
				find: "std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(count))",
				replace: "(static_cast<float>(i) + 0.5f) / static_cast<float>(count)",
				breaks: "samples of a disc are densest in its middle",
			},
		],
	},
	{
		file: `${SRC}/mesh/normals.hpp`,
		suites: [`${TESTS}/mesh/normals_test.cpp`],
		faults: [
			{
				id: "normals-not-unit",
				find: "length > least ? normal / length",
				replace: "length > least ? normal",
				breaks: "leaves are brighter or darker with their triangles' size",
			},
		],
	},
	{
		file: `${SRC}/stems/segment.hpp`,
		suites: [`${TESTS}/stems/segment_test.cpp`],
		faults: [
			{
				id: "segment-end-unscaled",
				find: "segment.radius_end *= factor;",
				replace: "",
				breaks: "stems end hundreds of times too thick",
			},
		],
	},
	{
		file: `${SRC}/foundation/random.cpp`,
		suites: [`${TESTS}/foundation/random_test.cpp`],
		faults: [
			{
				id: "random-highest-never",
				find: "(static_cast<std::int64_t>(high) - low) + 1;",
				replace: "(static_cast<std::int64_t>(high) - low);",
				breaks: "the highest whole number is never drawn",
			},
		],
	},
	{
		file: `${SRC}/foundation/fingerprint.hpp`,
		suites: [`${TESTS}/foundation/fingerprint_test.cpp`],
		faults: [
			{
				id: "fingerprint-minus-zero",
				find: "bit_cast<std::uint32_t>(value + 0.0f)",
				replace: "bit_cast<std::uint32_t>(value)",
				breaks: "−0 and 0 have two fingerprints",
			},
		],
	},
	{
		file: `${SRC}/foundation/container.cpp`,
		suites: [`${TESTS}/foundation/container_test.cpp`],
		faults: [
			{
				id: "container-bounds-unchecked",
				find: "|| data + column.bytes() > bytes.size()) return false;",
				replace: ") return false;",
				breaks: "a request may read what lies behind it",
			},
			{
				id: "container-padding-unfilled",
				find: "static_cast<std::size_t>(padded(length) - length));",
				replace: "0);",
				breaks: "answers hold what was in the memory before",
			},
		],
	},
	{
		file: `${SRC}/foundation/easing.hpp`,
		suites: [`${TESTS}/foundation/easing_test.cpp`],
		faults: [
			{
				id: "easing-hill-beyond-its-foot",
				find: "const float inside = std::max(0.0f, 1 - x * x * square);",
				replace: "const float inside = 1 - x * x * square;",
				breaks: "stems swell far from their nodes",
			},
		],
	},
	{
		file: `${SRC}/foundation/order.cpp`,
		suites: [`${TESTS}/foundation/order_test.cpp`],
		faults: [
			{
				id: "order-negative-reversed",
				find: "return bits & sign ? ~bits : bits | sign;",
				replace: "return bits | sign;",
				breaks: "numbers below 0 are in the wrong order",
			},
		],
	},
	{
		file: `${SRC}/spatial/sphere_grid.cpp`,
		suites: [`${TESTS}/spatial/sphere_grid_test.cpp`],
		faults: [
			{
				id: "sphere-grid-meets-its-parent",
				find: "if (!far[lane] && ids[first + lane] != except)",
				replace: "if (!far[lane])",
				breaks: "nothing can grow from what is there",
			},
			{
				id: "sphere-grid-forgets-on-growing",
				find: "for (std::uint32_t each = 0; each <= id; ++each) enlist(each);",
				replace: "enlist(id);",
				breaks: "small spheres vanish as soon as a large one comes",
			},
		],
	},
	{
		file: `${SRC}/spatial/sphere_overlaps.cpp`,
		suites: [`${TESTS}/spatial/sphere_overlaps_test.cpp`],
		faults: [
			{
				id: "touching-stems-by-their-start",
				find: "x -= t * way.x;",
				replace: "",
				breaks: "long stems are obstacles at one place only",
			},
			{
				id: "touching-first-left-out",
				find: "ids[slot + lane] >= least)",
				replace: "ids[slot + lane] > least)",
				breaks: "neighbours in a row are missed",
			},
		],
	},
	{
		file: `${SRC}/light/sky.cpp`,
		suites: [`${TESTS}/light/sky_test.cpp`],
		faults: [
			{
				id: "sky-hidden-by-oneself",
				find: " & mask(owner != self);",
				replace: ";",
				breaks: "every berry is black with its own shadow",
			},
			{
				id: "sky-lit-from-behind",
				find: "return max_of(sum, Four{});",
				replace: "return sum;",
				breaks: "what lies behind a point makes it brighter",
			},
			{
				id: "sky-near-ones-counted-twice",
				find: "far_balls_.constant -= 0.25f * hidden;",
				replace: "",
				breaks: "neighbours darken twice",
			},
			{
				id: "sky-below-the-horizon",
				find: "cosine >= sine ? sine * cosine : 0.25f * low * low",
				replace: "sine * sine",
				breaks: "what has half set hides as much as what stands overhead",
			},
		],
	},
	{
		file: `${SRC}/light/plant_sky.cpp`,
		suites: [`${TESTS}/light/plant_sky_test.cpp`],
		faults: [
			{
				id: "sky-leaves-dark-from-below",
				find: "into[k] = std::max(into[k], below[k]);",
				replace: ";",
				breaks: "leaves that face down are dark though the sky shines through them",
			},
			{
				id: "sky-stems-of-one-speck",
				find: "segment.start + way * (k / pieces)",
				replace: "segment.start",
				breaks: "long stems shade their lower end alone",
			},
		],
	},
	{
		file: `${SRC}/spatial/point_grid.cpp`,
		suites: [`${TESTS}/spatial/point_grid_test.cpp`],
		faults: [
			{
				id: "point-grid-places-what-is-nowhere",
				find: " && std::fabs(p.z) <= farthest;",
				replace: ";",
				breaks: "a number that is none breaks the grid",
			},
		],
	},
	{
		file: `${SRC}/spatial/closest_points.hpp`,
		suites: [`${TESTS}/spatial/closest_points_test.cpp`],
		faults: [
			{
				id: "closest-without-an-end",
				find: "std::clamp((ab * s - db) / b.square, -b.reach, b.reach)",
				replace: "(ab * s - db) / b.square",
				breaks: "segments count as endless lines",
			},
		],
	},
	{
		file: `${SRC}/stems/stem_rings.cpp`,
		suites: [`${TESTS}/stems/tubes_test.cpp`],
		faults: [
			{
				id: "rings-texture-twice-as-long",
				find: "const float per_circumference = 1 / (2 * pi *",
				replace: "const float per_circumference = 1 / (pi *",
				breaks: "bark is stretched",
			},
			{
				id: "rings-slope-forgotten",
				find: "rings[i].slope = (after.radius - before.radius) * per_run;",
				replace: "rings[i].slope = 0;",
				breaks: "tapered stems are shaded as cylinders",
			},
		],
	},
	{
		file: `${SRC}/stems/stem_thickness.cpp`,
		suites: [`${TESTS}/stems/tubes_test.cpp`, "tests/core/models/bunch/stems_test.cpp"],
		faults: [
			{
				id: "thickness-no-receptacle",
				find: "if (end_.flare != 0) factor +=",
				replace: "if (end_.flare < 0) factor +=",
				breaks: "berries have no receptacle to sit on",
			},
			{
				id: "thickness-joints-everywhere",
				find: "if (form_.jointed) {",
				replace: "if (form_.jointed || t >= 0) {",
				breaks: "petioles are strings of beads",
			},
		],
	},
	{
		file: `${SRC}/models/bunch/measures/images/bit_image.cpp`,
		suites: ["tests/core/models/bunch/measures/silhouette_test.cpp"],
		faults: [
			{
				id: "bit-image-last-word",
				find: "if (i == last) mask &= up_to_bit(to - i * word_bits);",
				replace: "",
				breaks: "rows are filled up to the next 64th pixel",
			},
		],
	},
	{
		file: `${SRC}/lsystem_plant/plain_plant.cpp`,
		suites: [`${TESTS}/lsystem_plant/plain_plant_test.cpp`],
		faults: [
			{
				id: "plain-turned-the-wrong-way",
				find: "return {way.z / length, 0, -way.x / length, w / length};",
				replace: "return {-way.z / length, 0, way.x / length, w / length};",
				breaks: "organs point back into their stems",
			},
		],
	},
	{
		file: `${SRC}/protocol/request.cpp`,
		suites: [`${TESTS}/exports/panicle_test.cpp`],
		faults: [
			{
				id: "request-unknown-blocks-pass",
				find: "    if (!read_[i]) return",
				replace: "    if (false) return",
				breaks: "a misspelt block is taken without a word",
			},
			{
				id: "request-of-any-width",
				find: "found->rows <= most / found->width",
				replace: "found->rows <= most",
				breaks: "a block of wide rows may be larger than is allowed",
			},
		],
	},
	{
		file: `${SRC}/protocol/answer.cpp`,
		suites: [`${TESTS}/exports/panicle_test.cpp`],
		faults: [
			{
				id: "answer-ends-are-starts",
				find: "put(segment.end, at + 3);",
				replace: "put(segment.start, at + 3);",
				breaks: "the page sees points in place of stems",
			},
			{
				id: "answer-no-column-of-errors",
				find: "diagnostic.line,\n                                            diagnostic.column};",
				replace: "diagnostic.line,\n                                            0};",
				breaks: "errors of grammars tell no column",
			},
		],
	},
	{
		file: `${SRC}/exports/panicle.cpp`,
		suites: [`${TESTS}/exports/panicle_test.cpp`],
		faults: [
			{
				id: "boundary-notes-twice",
				find: "  remove_repeated_notes(plant->notes);",
				replace: "",
				breaks: "a text whose derivation and drawing reach one limit has its note twice",
			},
			{
				id: "boundary-endless-requests",
				find: "return bytes <= max_request_bytes ?",
				replace: "return bytes != 1 ?",
				breaks: "a request may take all memory there is",
			},
		],
	},
];
