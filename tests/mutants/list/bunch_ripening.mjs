/** The natural procedure after swelling: ripening, hanging and meshes. */
const SRC = "wasm-core/src/models/bunch/natural";
const TESTS = "tests/core/models/bunch/natural";

export default [
	{
		file: `${SRC}/natural.cpp`,
		suites: [
			`${TESTS}/natural_outputs_test.cpp`,
			`${TESTS}/natural_counts_test.cpp`,
			`${TESTS}/natural_berries_test.cpp`,
			`${TESTS}/natural_outline_test.cpp`,
		],
		faults: [
			{
				id: "natural-flower-strength-unused",
				find: "situations[i].misplaced, flowers[i].strength,",
				replace: "situations[i].misplaced, 1,",
				breaks: "flowers at weak nodes set as if they were strong: bunches jump when a handle moves",
			},
			{
				id: "natural-shrivel-not-in-mesh",
				find: "harvest.bodies[k].shrivel = traits.back().shrivel;",
				replace: "",
				breaks: "raisins are smooth",
			},
			{
				id: "natural-surfaces-in-millimetres",
				find: "for (float& x : surfaces.positions) x *= metres_per_millimetre;",
				replace: "",
				breaks: "berries a thousand times too large",
			},
			{
				id: "natural-no-flowers-drawn",
				find: "if (flowers || grown.form.fruit == Fruit::bramble) {",
				replace: "if (grown.form.fruit == Fruit::bramble) {",
				breaks: "a bunch in flower shows no stamens",
			},
			{
				id: "natural-ovaries-as-fine-as-berries",
				find: "flowering ? ovary_segments : segments_for(bodies)",
				replace: "segments_for(bodies)",
				breaks: "an inflorescence has as many triangles as a ripe bunch",
			},
			{
				id: "natural-calyx-in-millimetres",
				find: "0.5f * ovary_width(values[size]) * metres_per_millimetre",
				replace: "0.5f * ovary_width(values[size])",
				breaks: "flowers and sepals are a thousand times too large",
			},
			{
				id: "natural-foliage-never",
				find: "if (!on_cane(values)) return std::nullopt;",
				replace: "if (leaf_count < 100) return std::nullopt;",
				breaks: "no cane and no leaves, however many are asked for",
			},
			{
				id: "natural-room-of-one-bunch",
				find: "target.most += plan.room;",
				replace: "target.most = plan.room;",
				breaks: "a bunch with a wing bears no more than its wing has room for",
			},
			{
				id: "natural-count-note-missing",
				find: "static_cast<float>(found_room) >= count_met * target.count ||",
				replace: "found_room > 0 ||",
				breaks: "nothing says that fewer berries than asked for found room",
			},
		],
	},
	{
		file: `${SRC}/harvest.cpp`,
		suites: [`${TESTS}/harvest_test.cpp`],
		faults: [
			{
				id: "harvest-lost-berry-in-millimetres",
				find: "swollen.ends[crop.berries[k].branch] * metres_per_millimetre}",
				replace: "swollen.ends[crop.berries[k].branch]}",
				breaks: "places of berries that found no room are a thousand times too far",
			},
			{
				id: "harvest-fallen-flower-in-millimetres",
				find: "(from < 0 ? first.end : first.start) * metres_per_millimetre}",
				replace: "(from < 0 ? first.end : first.start)}",
				breaks: "places of fallen flowers are a thousand times too far",
			},
			{
				id: "harvest-seat-beyond-the-berry",
				find: "outcome.seat = swollen.centres[k] - swollen.directions[k]",
				replace: "outcome.seat = swollen.centres[k] + swollen.directions[k]",
				breaks: "pedicels run through their berries to the tip",
			},
		],
	},
	{
		file: `${SRC}/settling/bending.cpp`,
		suites: [`${TESTS}/bending_test.cpp`],
		faults: [
			{
				id: "bending-girth-ignores-age",
				find: "const float girth = girth_at(size_) * metres_per_millimetre;",
				replace: "const float girth = metres_per_millimetre;",
				breaks: "stems are as stout in flower as when ripe",
			},
			{
				id: "bending-stub-as-long-as-ever",
				find: "return foot + along * stub_length;",
				replace: "return foot + along;",
				breaks: "pedicels of lost berries keep their length",
			},
			{
				id: "bending-no-seat",
				find: "internode.radius_end *= seat_widening;",
				replace: "",
				breaks: "pedicels have no receptacle",
			},
			{
				id: "bending-stubs-not-withered",
				find: "internode.state = State::withered;",
				replace: "internode.state = State::grown;",
				breaks: "stubs are as green as pedicels that bear",
			},
		],
	},
	{
		file: `${SRC}/ripening.cpp`,
		suites: [`${TESTS}/ripening_test.cpp`, `${TESTS}/traits_test.cpp`],
		faults: [
			{
				id: "ripening-shade-colours-first",
				find: "(0.5f - berry.exposure)",
				replace: "(berry.exposure - 0.5f)",
				breaks: "berries in the shade turn first",
			},
			{
				id: "ripening-never-shrinks",
				find: "(1 - 0.2f * smooth_step(102, 125, age))",
				replace: "1.0f",
				breaks: "raisins are as large as grapes",
			},
			{
				id: "ripening-vigour-unheeded",
				find: " + 4 * (1 - berry.vigour)",
				replace: "",
				breaks: "weak vines ripen as early as strong ones",
			},
			{
				id: "ripening-no-seeds",
				find: "(most + short_of_one_more)",
				replace: "short_of_one_more",
				breaks: "no berry has a seed",
			},
			{
				id: "ripening-seeds-in-the-seedless",
				find: "(most + short_of_one_more)",
				replace: "(4 + short_of_one_more)",
				breaks: "seedless grapes have seeds",
			},
			{
				id: "ripening-ovaries-with-relief",
				find: "return smooth_step(8, 24, age);",
				replace: "return 1;",
				breaks: "a bramble's flower is a small bramble",
			},
		],
	},
	{
		file: `${SRC}/berry_size.cpp`,
		suites: [`${TESTS}/berry_size_test.cpp`],
		faults: [
			{
				id: "berry-size-hunger-at-the-base",
				find: "(0.5f - situation.along)",
				replace: "(situation.along - 0.5f)",
				breaks: "without vigour the upper berries stay small, not the tip's",
			},
			{
				id: "berry-size-small-set-is-large",
				find: "* cube_root(volumes[k])",
				replace: "",
				breaks: "a berry that has only just set jumps into its full size",
			},
			{
				id: "berry-size-stand-ins-count",
				find: "k < regular; ++k",
				replace: "k < shares.size(); ++k",
				breaks: "who stands in changes the size of all others",
			},
		],
	},
	{
		file: `${SRC}/settling/exposure.cpp`,
		suites: [`${TESTS}/exposure_test.cpp`],
		faults: [
			{
				id: "exposure-shade-from-behind",
				find: "if (!(other.depth > lit.depth)) return;",
				replace: "if (!(other.depth < lit.depth)) return;",
				breaks: "berries behind shade those before them",
			},
			{
				id: "exposure-hard-shadows",
				find: "constexpr float penumbra = 0.25f",
				replace: "constexpr float penumbra = 0.001f",
				breaks: "colours jump as berries move",
			},
		],
	},
	{
		file: `${SRC}/traits.cpp`,
		suites: [`${TESTS}/traits_test.cpp`],
		faults: [
			{
				id: "traits-flowers-that-set-nothing",
				find: "berry.sets ? stage.set : 0",
				replace: "stage.set",
				breaks: "flowers that fall turn into berries first",
			},
			{
				id: "traits-length-is-width",
				find: "traits.length = 2 * berry.body.half_length",
				replace: "traits.length = 2 * berry.body.half_width",
				breaks: "files and measures say that fingers are balls",
			},
		],
	},
];
