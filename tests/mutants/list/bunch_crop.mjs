/** The crop of the natural procedure: where flowers are, which set, how many. */
const SRC = "wasm-core/src/models/bunch/natural";
const TESTS = "tests/core/models/bunch/natural";

export default [
	{
		file: `${SRC}/settling/fruit_set.cpp`,
		suites: [`${TESTS}/fruit_set_test.cpp`],
		faults: [
			{
				id: "fruit-set-own-strength-unused",
				find: "/ std::max(1e-6f, buds[i].strength)",
				replace: "",
				breaks: "weak flowers set as readily as strong ones",
			},
			{
				id: "fruit-set-other-bunch-crowds",
				find: "if (bunch_[slot + lane] == bud.bunch) crowd",
				replace: "crowd",
				breaks: "a wing and its bunch take each other's room where they have none in common",
			},
			{
				id: "fruit-set-misplaced-as-good",
				find: "* (1 + 4 * buds[i].misplaced)",
				replace: "",
				breaks: "berries set outside the profile",
			},
			{
				id: "fruit-set-crowd-counts-heads",
				find: "within[lane] * within[lane] * strength_[slot + lane]",
				replace: "within[lane] * within[lane]",
				breaks: "weak flowers crowd out strong ones",
			},
		],
	},
	{
		file: `${SRC}/situation.cpp`,
		suites: [`${TESTS}/situation_test.cpp`],
		faults: [
			{
				id: "situation-sun-from-the-other-side",
				find: "{up.cosine * turn.sine,",
				replace: "{-up.cosine * turn.sine,",
				breaks: "the shaded side colours first",
			},
			{
				id: "situation-raceme-misplaced",
				find: "situation.misplaced = raceme ? 0 : situation.misplaced / size;",
				replace: "situation.misplaced = situation.misplaced / size;",
				breaks: "currants lose their berries, which hang outside of what was drawn",
			},
			{
				id: "situation-lean-ignored",
				find: "upright.place(internodes[first].start)",
				replace: "internodes[first].start",
				breaks: "a wing's flowers count as outside of it, and others set as it comes down",
			},
			{
				id: "situation-lit-as-if-upright",
				find: "upright.way_back({own.x / half_x, 0, own.z / half_z})",
				replace: "glm::vec3(own.x / half_x, 0, own.z / half_z)",
				breaks: "a wing that stands out is lit as if it hung",
			},
		],
	},
	{
		file: `${SRC}/random_value.hpp`,
		suites: [`${TESTS}/situation_test.cpp`, `${TESTS}/traits_test.cpp`],
		faults: [
			{
				id: "luck-of-the-first-bunch",
				find: "bunch ? second_seed(seed) : seed",
				replace: "bunch ? seed : seed",
				breaks: "the wing is the bunch's twin, berry by berry",
			},
		],
	},
	{
		file: `${SRC}/settling/crowding.cpp`,
		suites: [`${TESTS}/crowding_test.cpp`],
		faults: [
			{
				id: "crowding-upright-berries-crowd-as-round-ones",
				find: "place.y / berry.elongation",
				replace: "place.y",
				breaks: "long berries are looser than was asked for",
			},
			{
				id: "crowding-wing-counted",
				find: "if (j <= i || berries[j].bunch != berries[i].bunch) continue;",
				replace: "if (j <= i) continue;",
				breaks: "a wing makes the bunch beside it looser",
			},
			{
				id: "crowding-found-at-the-first-guess",
				find: "constexpr int tries = 3;",
				replace: "constexpr int tries = 0;",
				breaks: "a bunch is as dense as most of its density are",
			},
			{
				id: "crowding-pushed-inside-for-nothing",
				find: "1 + pushed_in * buds[i].misplaced",
				replace: "1",
				breaks: "narrow bunches are denser than was asked for",
			},
		],
	},
	{
		file: `${SRC}/crop.cpp`,
		suites: [`${TESTS}/crop_test.cpp`],
		faults: [
			{
				id: "crop-thinning-by-hand-unheeded",
				find: "std::binary_search(target.taken.begin(), target.taken.end(), flowers[i].id)",
				replace: "false",
				breaks: "berries that were taken off grow back",
			},
			{
				id: "crop-stand-ins-set-already",
				find: "if (!(volumes[i] > 0) && in_turn.size() < most)",
				replace: "if (in_turn.size() < most)",
				breaks: "a berry hangs there twice",
			},
			{
				id: "crop-elongation-unheeded",
				find: "fruitlets[k].half_width * target.berry.elongation",
				replace: "fruitlets[k].half_width",
				breaks: "fingers swell as balls",
			},
			{
				id: "crop-beyond-the-room",
				find: "choose_count(own, std::min(target.count, target.most))",
				replace: "choose_count(own, target.count)",
				breaks: "counts beyond the outline's room heap up",
			},
		],
	},
];
