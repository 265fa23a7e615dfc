import { afterEach, expect, it, vi } from "vitest";
import { SolidView } from "../../../web/src/app/solid_view";
import { specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

/** A mock of the viewer, without a graphics card. */
const view = vi.hoisted(() => ({ use: vi.fn(), dispose: vi.fn(), modes: ["whole"], reducedMotion: false }));
vi.mock("../../../web/src/render/viewer", () => ({
	Viewer: class {
		constructor(_canvas: unknown, { reducedMotion }: { reducedMotion: boolean }) {
			view.reducedMotion = reducedMotion;
			// biome-ignore lint/correctness/noConstructorReturn: the one fake is looked at by the test.
			return view;
		}
	},
}));
afterEach(() => vi.unstubAllGlobals());

it("the 3-D view follows the reduced-motion preference until it is disposed", async () => {
	const query = Object.assign(new EventTarget(), { matches: true });
	vi.stubGlobal("matchMedia", () => query);
	const { studio } = await studioWith(specimenFromPreset());
	const solid = await SolidView.create({} as HTMLCanvasElement, studio, {
		lost: vi.fn(),
		restored: vi.fn(),
		motion: vi.fn(),
	});
	expect(view.reducedMotion).toBe(true);
	const change = (matches: boolean) => query.dispatchEvent(Object.assign(new Event("change"), { matches }));
	change(false);
	expect(view.reducedMotion).toBe(false);
	solid.dispose();
	change(true);
	expect(view.reducedMotion).toBe(false);
});
