/** Stands: the plan, where plants stand, what neighbours leave, and that each is grown by itself. */
const SRC = "wasm-core/src/models/stand";
const TESTS = "tests/core/models/stand";
const WEB = "tests/web/models/stand";

export default [
	{
		file: `${SRC}/places.cpp`,
		suites: [`${TESTS}/places_test.cpp`],
		faults: [
			{
				id: "stand-blue-darts-come-near",
				find: "free = glm::distance(spots[static_cast<std::size_t>(at)], dart) >= apart;",
				replace: "free = glm::distance(spots[static_cast<std::size_t>(at)], dart) >= 0.5f * apart;",
				breaks: "plants stand nearer to each other than the plan says",
			},
			{
				id: "stand-seeds-do-not-make-alike",
				find: "if (kind.seeds > 0) {",
				replace: "if (false) {",
				breaks: "plants of a line with so many seeds all differ",
			},
			{
				id: "stand-last-plants-are-lost",
				find: "static_cast<std::uint32_t>(upto * asked / all - before * asked / all);",
				replace: "static_cast<std::uint32_t>((upto - before) * asked / all);",
				breaks: "fewer plants stand than were asked for",
			},
			{
				id: "stand-borne-on-the-ground",
				find: "const float high = by.scale * drawn(kind.high, luck.unit(8 * k + 5));",
				replace: "const float high = 0 * luck.unit(8 * k + 5);",
				breaks: "bunches lie on the ground",
			},
		],
	},
	{
		file: `${SRC}/surroundings.cpp`,
		suites: [`${TESTS}/surroundings_test.cpp`],
		faults: [
			{
				id: "stand-surroundings-do-not-turn",
				find: "const float azimuth = arc_tangent(way.y, way.x) * 180 / pi - plants[i].turn;",
				replace: "const float azimuth = arc_tangent(way.y, way.x) * 180 / pi;",
				breaks: "a turned plant takes its neighbours to be elsewhere",
			},
			{
				id: "stand-higher-crowns-are-passed-over",
				find: "if (!within && above <= lowest * near) return;",
				replace: "if (!within) return;",
				breaks: "a tall tree behind a near one hides no sky",
			},
			{
				id: "stand-room-as-if-at-scale-1",
				find: "/ sincos_degrees(off).cosine / plants[i].scale);",
				replace: "/ sincos_degrees(off).cosine);",
				breaks: "small plants grow as if they had less room than they have",
			},
		],
	},
	{
		file: "web/src/models/members.ts",
		suites: [`${WEB}/members.test.ts`],
		faults: [
			{
				id: "stand-neighbours-are-not-told",
				find: "...(surroundings && model.surroundings ? { surroundings } : {}),",
				replace: "",
				breaks: "plants grow as if each stood alone",
			},
			{
				id: "stand-grown-anew-each-time",
				find: "if (done[at]) continue;",
				replace: "",
				breaks: "a change of the plan grows what has not changed once more",
			},
			{
				id: "stand-keeps-what-lacks-something",
				find: "if (read[at].prepared) kept",
				replace: "kept",
				breaks: "plants that lack what could not be fetched once lack it for ever",
			},
			{
				id: "stand-looks-of-its-own",
				find: "kept?.looks ?? new Looks()",
				replace: "new Looks()",
				breaks: "a file's bytes hang on what was edited before",
			},
		],
	},
	{
		file: "web/src/models/stand/figure/crowd.ts",
		suites: [`${WEB}/crowd.test.ts`],
		faults: [
			{
				id: "stand-coarse-for-ever",
				find: "this.#modest = 1;",
				replace: "",
				breaks: "a view in which there was too much leaves all later ones coarse",
			},
			{
				id: "stand-counts-what-is-not-there",
				find: "if (layers.length === 0) return;",
				replace: "",
				breaks: "a plant without triangles makes all others coarse",
			},
		],
	},
	{
		file: "web/src/models/stand/figure/level_choice.ts",
		suites: [`${WEB}/parts.test.ts`],
		faults: [
			{
				id: "stand-levels-pop",
				find: "const share = Math.ceil((STEPS * (size - from)) / (BAND * from)) / STEPS;",
				replace: "const share = 1 + 0 * STEPS * BAND;",
				breaks: "trees jump from one level of detail to the next",
			},
		],
	},
	{
		file: "web/src/models/stand/walker.ts",
		suites: [`${WEB}/parts.test.ts`],
		faults: [
			{
				id: "stand-walker-leaves-the-ground",
				find: "Math.min(0.5 * size, Math.max(-0.5 * size, value));",
				replace: "value + 0 * size;",
				breaks: "who walks on and on is nowhere",
			},
		],
	},
];
