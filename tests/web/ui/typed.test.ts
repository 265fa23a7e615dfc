import { expect, it, vi } from "vitest";
import { handBack, handOver, isForField, readTyped } from "../../../web/src/ui/typed";

const key = (name: string, more: object = {}) =>
	({ key: name, preventDefault: vi.fn(), ...more }) as unknown as KeyboardEvent;

it("reads numbers as people type them", () => {
	expect([" 3,5 ", "−2", "0", "1e2"].map(readTyped)).toEqual([3.5, -2, 0, 100]);
	expect(["", "wide", "1.2.3"].map(readTyped)).toEqual([Number.NaN, Number.NaN, Number.NaN]);
});

it("moves the focus from the slider for keys that begin a number only", () => {
	for (const name of ["Enter", "0", "9", "-", "−", ".", ","]) expect(isForField(key(name)), name).toBe(true);
	for (const name of ["ArrowLeft", "Delete", "k", "F1", "Home", " "]) expect(isForField(key(name)), name).toBe(false);
	expect(isForField(key("0", { ctrlKey: true }))).toBe(false);
});

it("passes the typed character to the field, but not Enter", () => {
	const field = { focus: vi.fn(), select: vi.fn() } as unknown as HTMLInputElement;
	const [digit, enter] = [key("4"), key("Enter")];
	handOver(digit, field);
	handOver(enter, field);
	expect(field.focus).toHaveBeenCalledTimes(2);
	expect(digit.preventDefault).not.toHaveBeenCalled();
	expect(enter.preventDefault).toHaveBeenCalledOnce();
});

it("returns to the slider with Enter, and discards the text with Escape", () => {
	const slider = { focus: vi.fn() } as unknown as HTMLInputElement;
	const typed = (name: string) => {
		const target = { value: "41" };
		handBack(key(name, { target }), 300, slider);
		return target.value;
	};
	expect(["4", "Enter", "Escape"].map(typed)).toEqual(["41", "41", "300"]);
	expect(slider.focus).toHaveBeenCalledTimes(2);
});
