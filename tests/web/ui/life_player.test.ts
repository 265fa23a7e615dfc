import { beforeEach, describe, expect, it } from "vitest";
import type { Studio } from "../../../web/src/app/studio";
import { LIFE } from "../../../web/src/models/bunch/ui/age";
import type { Stateful } from "../../../web/src/ui/editor_context";
import { LifePlayer, type PlayState } from "../../../web/src/ui/life_player";
import { studioWith } from "../app/context";
import { specimenFromPreset } from "../bunch";

const opened = specimenFromPreset("long-conical");
const FRAME = 20;
const PLAYED: Stateful<PlayState> = { name: "played", initial: { playing: false } };

describe("the player of a life", () => {
	let studio: Studio;
	let player: LifePlayer;
	let due: ((now: number) => void) | undefined;
	let now = 0;
	let stepwise = false;

	const age = () => studio.state.specimen.parameters.age;
	const playing = () => studio.toolState(PLAYED).playing;
	const play = (on: boolean) => studio.setToolState(PLAYED, { playing: on });
	/** Advances time frame by frame and returns the ages shown. */
	const run = (milliseconds: number) => {
		const seen: number[] = [];
		for (const end = now + milliseconds; now < end && due; now += FRAME) {
			const callback = due;
			due = undefined;
			callback(now);
			seen.push(age());
		}
		return seen;
	};

	beforeEach(async () => {
		due = undefined;
		stepwise = false;
		({ studio } = await studioWith(opened));
		player = new LifePlayer(studio, LIFE, PLAYED, {
			request: (callback) => {
				due = callback;
			},
			stepwise: () => stepwise,
		});
	});

	it("does not start by itself", () => expect(due).toBeUndefined());

	it("plays from the first flowers to ripe in about nine seconds, never back, without skipping a step", () => {
		play(true);
		const seen = run(20_000);
		expect(seen[0]).toBe(0);
		expect(seen.length * FRAME).toBeGreaterThan(8000);
		expect(seen.length * FRAME).toBeLessThan(10_000);
		expect(seen).toEqual([...seen].sort((a, b) => a - b));
		expect(age()).toBe(100);
		expect(playing()).toBe(false);
		expect(studio.state.history.past).toHaveLength(0);
		expect(studio.state.history.gesture).toBeUndefined();
	});

	it("continues from the current age, and a pause is one undo step", () => {
		studio.set({ parameters: { age: 40 } });
		play(true);
		const seen = run(1000);
		expect(seen[0]).toBe(40);
		play(false);
		expect(age()).toBeGreaterThan(45);
		expect(due?.(now)).toBeUndefined();
		const stopped = age();
		run(1000);
		expect(age()).toBe(stopped);
		studio.undo();
		expect(age()).toBe(40);
	});

	it.each([
		["a handle is dragged", () => studio.edit({ parameters: { l: 300 } })],
		["the age is taken in hand", () => studio.edit({ parameters: { age: 3 } })],
		["a preset is chosen", () => studio.choosePreset("duku")],
		["it is undone", () => studio.undo()],
	])("stops where %s, and leaves that alone", (_, act) => {
		play(true);
		run(1000);
		act();
		const taken = studio.state.specimen;
		run(1000);
		expect(playing()).toBe(false);
		expect(studio.state.specimen).toBe(taken);
	});

	it("continues where it was after the page was hidden", () => {
		play(true);
		run(1000);
		const before = age();
		now += 60_000;
		run(FRAME);
		expect(age() - before).toBeLessThan(10);
	});

	it("moves from stage to stage with reduced motion", () => {
		stepwise = true;
		play(true);
		expect([...new Set(run(20_000))]).toEqual([0, 10, 30, 60, 100]);
		expect(playing()).toBe(false);
	});

	it("changes its speed as set, also during playing, and remembers it", () => {
		const at = (speed: number) => studio.setToolState(PLAYED, { ...studio.toolState(PLAYED), speed });
		at(4);
		studio.setToolState(PLAYED, { playing: true, speed: 4 });
		expect(run(20_000).length * FRAME).toBeLessThan(2600);
		expect(studio.toolState(PLAYED)).toEqual({ playing: false, speed: 4 });
		studio.setToolState(PLAYED, { playing: true, speed: 4 });
		run(500);
		const fast = age();
		at(0.25);
		run(500);
		expect(fast).toBeGreaterThan(15);
		expect(age() - fast).toBeGreaterThan(0);
		expect(age() - fast).toBeLessThan(3);
	});

	it("runs one loop of frames, even if it is stopped and started again before the next frame", () => {
		const frames: ((now: number) => void)[] = [];
		const clock = { request: (frame: (now: number) => void) => void frames.push(frame), stepwise: () => false };
		player.dispose();
		player = new LifePlayer(studio, LIFE, PLAYED, clock);
		for (let press = 0; press < 5; press++) play(press % 2 === 0);
		for (let frame = 0; frame < 3; frame++) {
			expect(frames).toHaveLength(1);
			frames.shift()?.(FRAME * frame);
		}
		player.dispose();
	});

	it("stops when disposed: the current age becomes an undo step, and no frame follows", () => {
		play(true);
		run(1000);
		const stopped = age();
		player.dispose();
		expect(playing()).toBe(false);
		expect(studio.state.history.gesture).toBeUndefined();
		run(1000);
		play(true);
		run(1000);
		expect(age()).toBe(stopped);
	});
});
