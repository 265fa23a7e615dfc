import { expect, it, vi } from "vitest";
import { listenForSkips } from "../../../web/src/app/skips";

/** A page that records the click listener, with one target element. */
function page() {
	const place = { focus: vi.fn() };
	let listener: (event: unknown) => void = () => {};
	const document = {
		addEventListener: (_type: string, each: typeof listener) => {
			listener = each;
		},
		removeEventListener: vi.fn(),
		getElementById: (id: string) => (id === "controls" ? place : null),
	};
	const click = (hash: string | undefined) => {
		const event = { preventDefault: vi.fn(), target: { closest: () => (hash === undefined ? null : { hash }) } };
		listener(event);
		return event.preventDefault.mock.calls.length > 0;
	};
	const end = listenForSkips(document as unknown as Document);
	return { place, click, end, document };
}

it("links within the page move the focus and leave the address unchanged", () => {
	const { place, click, end, document } = page();
	expect([click(undefined), click("#elsewhere")]).toEqual([false, false]);
	expect(place.focus).not.toHaveBeenCalled();
	expect(click("#controls")).toBe(true);
	expect(place.focus).toHaveBeenCalledOnce();
	end();
	expect(document.removeEventListener).toHaveBeenCalledOnce();
});
