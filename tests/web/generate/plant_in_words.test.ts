import { expect, it } from "vitest";
import { plantInWords } from "../../../web/src/generate/plant_in_words";
import type { PageModel } from "../../../web/src/models/page_model";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";

it.each([
	["Riesling", "bunch", "12 cm long, with 99 berries", "Riesling bunch: 12 cm long, with 99 berries"],
	["Double bunch, winged", "bunch", "99 berries", "Double bunch, winged: 99 berries"],
	["Oak", "leaf", "Oak leaf, 42 cm², 11 cm long", "Oak leaf, 42 cm², 11 cm long"],
	["Oak", "tree", "9.2 m tall, 5,400 leaves", "Oak tree: 9.2 m tall, 5,400 leaves"],
	["Carrot", "root", "19 cm deep, 60 root tips", "Carrot root: 19 cm deep, 60 root tips"],
])("says of a %s that it is a %s, once", (title, plantName, summary, whole) => {
	const model = {
		plantName,
		title: "Plant",
		presets: { named: () => ({ title }) },
		summary: () => summary,
	} as unknown as PageModel;
	expect(plantInWords({ model, specimen: { preset: "a" } as never, grown: EMPTY_PLANT })).toBe(whole);
});
