import { expect, it, vi } from "vitest";
import { rove, stopAt } from "../../../web/src/ui/roving";

const row = () => Array.from({ length: 3 }, () => ({ tabIndex: -1, focus: vi.fn() })) as unknown as HTMLElement[];
const press = (key: string, target: unknown) => ({ key, target, preventDefault: vi.fn() }) as unknown as KeyboardEvent;

it("has one tab stop, which the arrow keys, Home and End move", () => {
	const items = row();
	stopAt(items, items[0]);
	const stops = () => items.map(({ tabIndex }) => tabIndex);
	expect(stops()).toEqual([0, -1, -1]);
	let at = 0;
	for (const [key, next] of [
		["ArrowRight", 1],
		["ArrowDown", 2],
		["ArrowLeft", 1],
		["ArrowUp", 0],
		["End", 2],
		["Home", 0],
	] as const) {
		expect(rove(press(key, items[at]), items), key).toBe(true);
		at = next;
		expect(stops().indexOf(0), key).toBe(next);
	}
	expect(items.map(({ focus }) => vi.mocked(focus).mock.calls.length)).toEqual([2, 2, 2]);
});

it("stops at its ends, and ignores other keys and other elements", () => {
	const items = row();
	for (const event of [
		press("ArrowLeft", items[0]),
		press("ArrowRight", items[2]),
		press("a", items[1]),
		press("Home", {}),
	]) {
		expect(rove(event, items)).toBe(false);
		expect(event.preventDefault).not.toHaveBeenCalled();
	}
});
