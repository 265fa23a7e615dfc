/** The surfaces of a bunch in the core: stems, fruit, leaves, and the sky they see. */
const SRC = "wasm-core/src/models/bunch";
const TESTS = "tests/core/models/bunch";

export default [
	{
		file: `${SRC}/stems.cpp`,
		suites: [`${TESTS}/stems_test.cpp`],
		faults: [
			{
				id: "stems-withered-not-shrivelled",
				find: "internode.state == State::withered ? shrivelled : receptacle",
				replace: "receptacle",
				breaks: "withered pedicels look like those that bear",
			},
			{
				id: "stems-rings-where-nodes-crowd",
				find: "stems.tapering = natural;",
				replace: "",
				breaks: "a lychee's stalk looks turned",
			},
		],
	},
	{
		file: `${SRC}/bunch_sky.cpp`,
		suites: [`${TESTS}/bunch_sky_test.cpp`],
		faults: [
			{
				id: "bunch-sky-shared-berry-upright",
				find: "const glm::vec3& to = berry.direction;",
				replace: "const glm::vec3 to(0, 1, 0);",
				breaks: "berries of the paper are dark at the wrong side",
			},
			{
				id: "bunch-sky-fingers-as-balls",
				find: "if (!(ratio >= two_from)) {",
				replace: "if (ratio > 0) {",
				breaks: "fingers shade as balls do",
			},
		],
	},
	{
		file: `${SRC}/berry/berry_gauge.cpp`,
		suites: [`${TESTS}/berry/berry_surfaces_test.cpp`],
		faults: [
			{
				id: "gauge-berries-unbent",
				find: "const float bow = deepest_bow * form.curve;",
				replace: "const float bow = 0 * form.curve;",
				breaks: "horn-shaped berries are straight",
			},
			{
				id: "gauge-raisins-do-not-cave-in",
				find: "dent * dent * per_dent * (caved * shrivel)",
				replace: "dent * dent * per_dent * (0 * caved * shrivel)",
				breaks: "raisins are round, and only creased",
			},
		],
	},
	{
		file: `${SRC}/berry/fruit_skin.cpp`,
		suites: [`${TESTS}/berry/berry_surfaces_test.cpp`],
		faults: [
			{
				id: "skin-rinds-fold",
				find: "return 0.25f;",
				replace: "return 1;",
				breaks: "dry longans are walnuts",
			},
			{
				id: "skin-scar-drilled",
				find: "-0.012f * hill(from_tip / 0.30f)",
				replace: "-0.040f * hill(from_tip / 0.30f)",
				breaks: "tip scars are holes",
			},
		],
	},
	{
		file: `${SRC}/berry/pressing/berry_press.cpp`,
		suites: [`${TESTS}/berry/berry_surfaces_test.cpp`],
		faults: [
			{
				id: "press-all-marked",
				find: "pressed[lane] = static_cast<std::uint8_t>(share[lane]);",
				replace: "pressed[lane] = 255;",
				breaks: "wax is rubbed off all over",
			},
			{
				id: "press-volume-not-kept",
				find: "aim = volume * rough.value / exact;",
				replace: "return 0;",
				breaks: "pressed berries are too small",
			},
			{
				id: "press-normals-inwards",
				find: "put(normals, nx * per_length,",
				replace: "put(normals, -nx * per_length,",
				breaks: "berries are lit from the wrong side",
			},
		],
	},
	{
		file: `${SRC}/berry/wrinkles.cpp`,
		suites: [`${TESTS}/berry/wrinkles_test.cpp`],
		faults: [
			{
				id: "wrinkles-slope-reversed",
				find: "wave.way * (share * cosine(angle))",
				replace: "wave.way * (-share * cosine(angle))",
				breaks: "furrows of raisins look raised",
			},
		],
	},
	{
		file: `${SRC}/berry/pressing/projection.cpp`,
		suites: [`${TESTS}/berry/projection_test.cpp`],
		faults: [
			{
				id: "projection-tilt-ignored",
				find: "suv = excess * u * v,",
				replace: "suv = 0,",
				breaks: "outlines of leaning fingers are upright",
			},
		],
	},
	{
		file: `${SRC}/foliage/leaf.cpp`,
		suites: [`${TESTS}/foliage/leaf_test.cpp`],
		faults: [
			{
				id: "leaf-mirrored-inside-out",
				find: "relief.side < 0);",
				replace: "relief.side > 2);",
				breaks: "every other leaf shows its lower face to the light",
			},
		],
	},
	{
		file: "wasm-core/src/foliage/flat_leaf.cpp",
		suites: [`${TESTS}/foliage/leaf_test.cpp`],
		faults: [
			{
				id: "leaf-triangles-unchecked",
				find: "return i >= points;",
				replace: "return i > points;",
				breaks: "a request's leaf may read beyond its points",
			},
		],
	},
];
