/** The stages of a bunch's life, by the parameter `age` in percent. */

export interface Stage {
	/** Percent. */
	readonly at: number;
	readonly name: string;
}

/** From here on there are berries. */
export const FRUIT_SET = 10;
/** Where the play ends. */
export const RIPE = 100;

export const STAGES: readonly Stage[] = [
	{ at: 0, name: "Flowering" },
	{ at: FRUIT_SET, name: "Fruit set" },
	{ at: 30, name: "Green" },
	{ at: 60, name: "Colouring" },
	{ at: RIPE, name: "Ripe" },
	{ at: 125, name: "Shrivelled" },
];

/** Past ripe, a bunch is named for where it goes from here on. */
const SHRIVELLING = 110;

/** What a bunch of that age is called. */
export function stageOf(age: number): Stage {
	if (age >= SHRIVELLING) return STAGES[STAGES.length - 1];
	return STAGES.findLast(({ at }) => at <= age) ?? STAGES[0];
}

/** The stage after that age, or before it; the ends stay. */
export function nextStage(age: number, direction: 1 | -1): Stage {
	return direction > 0
		? (STAGES.find(({ at }) => at > age) ?? STAGES[STAGES.length - 1])
		: (STAGES.findLast(({ at }) => at < age) ?? STAGES[0]);
}
