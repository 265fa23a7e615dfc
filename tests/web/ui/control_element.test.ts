import { describe, expect, it, vi } from "vitest";
import type { Model } from "../../../web/src/models/model";
import { ControlElement } from "../../../web/src/ui/control_element";
import type { EditorContext } from "../../../web/src/ui/editor_context";
import { studioWith } from "../app/context";
import { specimenFromPreset } from "../bunch";
import { toy } from "../toy";

/** Runs the checks that Lit makes before drawing, without a page. */
class Probe extends ControlElement {
	readonly drawn = vi.fn();

	protected override draw(context: EditorContext): unknown {
		this.drawn(context.state.model.name);
		return "";
	}

	needsUpdate(...changed: string[]): boolean {
		return this.shouldUpdate(new Map(changed.map((name) => [name, undefined])));
	}
}
customElements.define("panicle-probe", Probe);

describe("a control", () => {
	it("stands still once another model has come, until the page puts it to use again", async () => {
		const { studio } = await studioWith(specimenFromPreset());
		const probe = new Probe();
		expect(probe.needsUpdate()).toBe(false);
		probe.context = studio;
		expect(probe.needsUpdate("context")).toBe(true);
		expect(probe.needsUpdate()).toBe(true);
		studio.choosePreset("plain", toy as unknown as Model);
		expect(probe.needsUpdate()).toBe(false);
		studio.undo();
		expect(probe.needsUpdate()).toBe(true);
		studio.redo();
		expect(probe.needsUpdate("life")).toBe(true);
	});
});
