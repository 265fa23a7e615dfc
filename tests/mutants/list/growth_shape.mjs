/** Trees by divisor functions: light and room, and levels of detail. */
const SRC = "wasm-core/src/models/growth";
const TESTS = "tests/core/models/growth";
const LEVELS = [`${TESTS}/levels_test.cpp`];
const ABOUT = [`${TESTS}/surroundings_test.cpp`, `${TESTS}/form_test.cpp`];

export default [
	{
		file: `${SRC}/form.cpp`,
		suites: ABOUT,
		faults: [
			{
				id: "growth-light-is-always-above",
				find: "const glm::vec3 light = light_.from(tip);",
				replace: "const glm::vec3 light(0, 1, 0);",
				breaks: "trees in the shade of others do not bend out of it",
			},
			{
				id: "growth-shoots-leave-their-room",
				find: "i < max_halvings && regard > 0 && !surroundings_.contains",
				replace: "i < 0 && regard > 0 && !surroundings_.contains",
				breaks: "branches grow into the crowns beside them",
			},
			{
				id: "growth-deformed-for-a-step",
				find: "deformed_[population_.deformations[next_].shoot] = population_.deformations[next_];",
				replace: "deformed_[population_.deformations[next_].shoot] = {};",
				breaks: "branches with a will of their own are as all others",
			},
			{
				id: "growth-volumes-do-not-guide",
				find: "constexpr float beyond = 0.5f;",
				replace: "constexpr float beyond = 1;",
				breaks: "crowns reach far beyond the volumes that one drags",
			},
		],
	},
	{
		file: `${SRC}/free_room.cpp`,
		suites: [`${TESTS}/free_room_test.cpp`],
		faults: [
			{
				id: "growth-end-of-a-run-unseen",
				find: "slot < end; slot += lanes",
				replace: "slot + lanes <= end; slot += lanes",
				breaks: "where few stand about a tip, it grows through them",
			},
			{
				id: "growth-nowhere-is-free",
				find: "auto taken = somewhere != somewhere;",
				replace: "auto taken = seen & ~seen;",
				breaks: "a number that is none bends a shoot towards nothing in particular",
			},
			{
				id: "growth-places-at-one-depth",
				find: "deep = turned - (turned >= 1.0f ? all_of(1) : all_of(0))",
				replace: "deep = turned - turned",
				breaks: "tips look to places half as far as they might",
			},
			{
				id: "growth-behind-is-ahead",
				find: "const Four weight = seen ? worth : all_of(0);",
				replace: "const Four weight = worth;",
				breaks: "shoots are drawn to free places behind them",
			},
		],
	},
	{
		file: `${SRC}/surroundings.cpp`,
		suites: ABOUT,
		faults: [
			{
				id: "growth-room-of-the-widest-side",
				suites: [`${TESTS}/free_room_test.cpp`],
				find: "about.least_ = std::min(about.least_, surely * near);",
				replace: "",
				breaks: "tips look for room in the crowns of neighbours",
			},
			{
				id: "growth-horizon-hides-nothing",
				find: "direction.share = 0;",
				replace: "direction.share *= 1;",
				breaks: "the sky behind neighbours is as light as any",
			},
			{
				id: "growth-room-is-a-circle",
				find: "const std::size_t i = octant_of(p.x, p.z), next",
				replace: "const std::size_t i = 0, next",
				breaks: "room is that of the east all about",
			},
		],
	},
	{
		file: `${SRC}/crown_light.cpp`,
		suites: ABOUT,
		faults: [
			{
				id: "growth-light-from-the-dark",
				find: "sky_ + contrast *",
				replace: "sky_ - contrast *",
				breaks: "shoots grow to where the crown is thickest",
			},
			{
				id: "growth-spiral-leans",
				find: "visible_sky - glm::vec3(full_sky.x, 0, full_sky.z)",
				replace: "visible_sky",
				breaks: "a tree with nothing about it is another than one that stands alone",
			},
		],
	},
	{
		file: `${SRC}/levels.cpp`,
		suites: LEVELS,
		faults: [
			{
				id: "levels-thin-wood-first",
				find: "return radius_a != radius_b ? radius_a > radius_b : a.first < b.first;",
				replace: "return radius_a != radius_b ? radius_a < radius_b : a.first < b.first;",
				breaks: "far trees have twigs and no trunk",
			},
			{
				id: "levels-bare-trees-lose-their-outline",
				find: "leafy_ || level == 0 ? std::vector<bool>() : outermost();",
				replace: "std::vector<bool>();",
				breaks: "trees in winter shrink as one walks away",
			},
			{
				id: "levels-tubes-inside-out",
				find: "turn.cosine * right + turn.sine * forward",
				replace: "turn.cosine * right - turn.sine * forward",
				breaks: "wood is lit from the wrong side",
			},
			{
				id: "levels-never-fewer-corners",
				find: "if (straight) continue;",
				replace: "if (straight && level_count == 0) continue;",
				breaks: "far trunks have a ring for each branch",
			},
		],
	},
	{
		file: `${SRC}/sheets.cpp`,
		suites: LEVELS,
		faults: [
			{
				id: "levels-merged-leaves-lose-area",
				find: "sheet.area += sheets_[k].area;",
				replace: "sheet.area = sheets_[k].area;",
				breaks: "crowns get thin with distance",
			},
			{
				id: "levels-crowns-shrink",
				find: "stretch_to(merged, target);",
				replace: "",
				breaks: "crowns shrink as one walks away",
			},
		],
	},
];
