import { afterEach, expect, it, vi } from "vitest";
import type { StandSpecimen } from "../../../../web/src/models/stand/specimen";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { map } from "../../../../web/src/models/stand/ui/map";
import type { EditorContext } from "../../../../web/src/ui/editor_context";
import type { ToolView } from "../../../../web/src/ui/tool";

afterEach(() => vi.unstubAllGlobals());

const body = { closest: () => null };
const inChip = { closest: (where: string) => (where === ".stage-chip" ? {} : null) };
const elsewhere = { closest: () => null };

it.each([
	["that goes", inChip, 1],
	["that has gone", body, 1],
	["of another place", elsewhere, 0],
])("the picture takes the focus of a button %s once no plant is chosen", (_, activeElement, times) => {
	vi.stubGlobal("document", { body, activeElement });
	vi.stubGlobal("window", new EventTarget());
	let chosen: number | undefined = 2;
	const context = { state: { grown: { places: { count: 3 } } }, toolState: () => chosen };
	const focus = vi.fn();
	const canvas = { focus, addEventListener: () => {}, classList: { toggle: () => {} } };
	const view = { canvas, mark: vi.fn(), pick: () => undefined } as unknown as ToolView;
	const interaction = map.interaction?.(view, context as unknown as EditorContext<StandSpecimen, StandPlant>);
	interaction?.update(context.state as never);
	expect(focus).not.toHaveBeenCalled();
	chosen = undefined;
	interaction?.update(context.state as never);
	interaction?.update(context.state as never);
	expect(focus).toHaveBeenCalledTimes(times);
	expect(view.mark).toHaveBeenLastCalledWith(undefined);
});

it.each([
	["anywhere", body, false, true],
	[
		"in the number of the plant",
		{ closest: (of: string) => (of.includes("input") ? { closest: () => ({}) } : null) },
		false,
		true,
	],
	[
		"in another field",
		{ closest: (of: string) => (of.includes("input") ? { closest: () => null } : null) },
		false,
		false,
	],
	["where something else has taken it", body, true, false],
])("Escape %s", (_, target, taken, leaves) => {
	const page = new EventTarget();
	vi.stubGlobal("document", { body, activeElement: elsewhere, querySelector: () => null });
	vi.stubGlobal("window", page);
	const setToolState = vi.fn();
	const context = { state: { grown: { places: { count: 3 } } }, toolState: () => 2, setToolState };
	const canvas = {
		focus: vi.fn(),
		addEventListener: () => {},
		removeEventListener: () => {},
		classList: { toggle: () => {} },
	};
	const view = { canvas, mark: vi.fn(), pick: () => undefined } as unknown as ToolView;
	const interaction = map.interaction?.(view, context as unknown as EditorContext<StandSpecimen, StandPlant>);
	const press = (key: string) => {
		const event = new Event("keydown", { cancelable: true });
		Object.defineProperties(event, { key: { value: key }, target: { value: target } });
		if (taken) event.preventDefault();
		page.dispatchEvent(event);
	};
	press("n");
	expect(setToolState).not.toHaveBeenCalled();
	press("Escape");
	expect(setToolState.mock.calls.map(([, chosen]) => chosen)).toEqual(leaves ? [undefined] : []);
	interaction?.dispose();
	setToolState.mockClear();
	press("Escape");
	expect(setToolState).not.toHaveBeenCalled();
});
