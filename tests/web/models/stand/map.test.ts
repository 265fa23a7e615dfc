import { afterEach, expect, it, vi } from "vitest";
import type { Desk } from "../../../../web/src/controls/desk";
import type { ToolView } from "../../../../web/src/controls/tool";
import type { StandSpecimen } from "../../../../web/src/models/stand/specimen";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { map } from "../../../../web/src/models/stand/tools/map";

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
	let chosen: number | undefined = 2;
	const desk = { state: { grown: { places: { count: 3 } } }, toolState: () => chosen };
	const focus = vi.fn();
	const canvas = { focus, addEventListener: () => {}, classList: { toggle: () => {} } };
	const view = { canvas, mark: vi.fn(), pick: () => undefined } as unknown as ToolView;
	const hands = map.hands?.(view, desk as unknown as Desk<StandSpecimen, StandPlant>);
	hands?.update(desk.state as never);
	expect(focus).not.toHaveBeenCalled();
	chosen = undefined;
	hands?.update(desk.state as never);
	hands?.update(desk.state as never);
	expect(focus).toHaveBeenCalledTimes(times);
	expect(view.mark).toHaveBeenLastCalledWith(undefined);
});
