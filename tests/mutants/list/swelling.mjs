/** How berries swell among each other. */
const NATURAL = "tests/core/models/bunch/natural";

export default [
	{
		file: "wasm-core/src/models/bunch/natural/settling/swelling.cpp",
		suites: [`${NATURAL}/swelling_test.cpp`],
		faults: [
			{ id: "swelling-stems-do-not-part", find: "part_stems();", replace: ";", breaks: "stems go through berries" },
			{
				id: "swelling-shortest-pedicel-ignored",
				find: "least = shortest * size.stalk + size.half_length",
				replace: "least = 0",
				breaks: "berries are pressed back onto the stem that bears them",
			},
			{
				id: "swelling-no-thinning-on-the-way",
				find: "index % refresh == refresh - 1) thin(1);",
				replace: "index % refresh == refresh - 1) return;",
				breaks: "who finds no room is lost at the end only, so that drying bunches lose others",
			},
			{
				id: "swelling-thinning-measures-each-round",
				find: "const std::vector<std::uint32_t> lost = crowded_out(pressing, sizes_);",
				replace: "const std::vector<std::uint32_t> lost = crowded_out(pressing = presses(), sizes_);",
				suites: [`${NATURAL}/natural_cost_test.cpp`],
				breaks: "each round of thinning measures anew how deep all berries press",
			},
			{
				id: "swelling-gravity-upwards",
				find: "centres_[i].y -= gravity",
				replace: "centres_[i].y += gravity",
				breaks: "berries rise",
			},
			{
				id: "swelling-outline-ignored",
				find: "keep_within();",
				replace: ";",
				breaks: "berries leave the drawn profile",
			},
			{
				id: "swelling-one-sided-push",
				find: "centres_[j] += direction * push;",
				replace: "",
				breaks: "of two berries that touch only one gives way",
			},
			{
				id: "swelling-by-hand-is-no-room",
				find: "lost_[i] = RemovalReason::by_hand;",
				replace: "lost_[i] = RemovalReason::no_room;",
				breaks: "a berry taken off by hand is said to have found no room",
			},
			{
				id: "swelling-branches-spring-back",
				find: "ends_[k] = rest + (ends_[k] - rest) * branch.give;",
				replace: "ends_[k] = rest;",
				breaks: "branches never give way to what they bear",
			},
			{
				id: "swelling-pedicels-turn-round",
				find: "if (turned < max_bent)",
				replace: "if (turned < -2)",
				breaks: "a pedicel may point back into the stem",
				survives:
					"a pedicel is a spring: no stem and no outline was found that turns one round against it, with the rule or without; only crowds may",
			},
			{
				id: "swelling-stalk-ignores-age",
				find: "0.45f * std::min(1.0f, size / 0.6f)",
				replace: "0.45f",
				breaks: "pedicels are as long in flower as when ripe",
			},
			{
				id: "swelling-late-join-unasked",
				find: "if (static_cast<float>(remaining) >= near_enough * static_cast<float>(wanted)) return index;",
				replace: "",
				breaks: "more berries grow than were asked for",
			},
			{
				id: "swelling-foot-never-moves",
				find: "foot += heading * (excess * give);",
				replace: "",
				breaks: "a berry's pull is not felt by the branch it hangs on",
			},
		],
	},
	{
		file: "wasm-core/src/models/bunch/natural/settling/swelling.cpp",
		suites: [`${NATURAL}/natural_counts_test.cpp`],
		faults: [
			{
				id: "swelling-all-that-join-stay",
				find: "present_count() > wanted; young_.pop_back()",
				replace: "false; young_.pop_back()",
				breaks: "more berries than were asked for",
			},
		],
	},
	{
		file: "wasm-core/src/models/bunch/natural/settling/thinning.cpp",
		suites: [`${NATURAL}/thinning_test.cpp`],
		faults: [
			{
				id: "thinning-neighbours-go-too",
				find: "sizes.size(); ++i)\n    if (pressed[i] > max_pressed && !keeps[i])",
				replace: "sizes.size(); ++i)\n    if (pressed[i] > max_pressed || !keeps[i])",
				breaks: "berries are lost that have room once their neighbour is gone",
			},
			{
				id: "thinning-fingers-as-balls",
				find: "+ 6 * r * r * size.core",
				replace: "",
				breaks: "long berries are lost for contacts that take little of them",
			},
		],
	},
	{
		file: "wasm-core/src/models/bunch/natural/settling/spreading.cpp",
		suites: [`${NATURAL}/spreading_test.cpp`],
		faults: [
			{
				id: "spreading-lifts",
				find: "glm::vec3(sideways.x, -weight * berry.size.ball, sideways.z)",
				replace: "sideways",
				breaks: "pedicels push each other's berries up, and bunches do not hang",
			},
			{
				id: "spreading-shot-berries-push",
				find: "2 * all[i].mass / (all[i].mass + all[j].mass)",
				replace: "1",
				breaks: "a flower that only just sets moves its neighbours",
			},
			{
				id: "spreading-room-for-the-late",
				find: "berries[i].late ? -1 : ",
				replace: "",
				breaks: "berries make room for some that never grow",
			},
		],
	},
	{
		file: "wasm-core/src/models/bunch/natural/settling/swelling.cpp",
		suites: ["tests/web/models/bunch/contacts.test.ts"],
		faults: [
			{
				id: "swelling-nobody-slides",
				find: "leans_ = spread(branches, berries, sagging_.turned(1));",
				replace: "leans_.resize(berries.size());",
				breaks: "berries that would hang in one place press deeply on each other",
			},
		],
	},
];
