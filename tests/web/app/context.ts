import { vi } from "vitest";
import { Studio } from "../../../web/src/app/studio";
import type { StudioServices } from "../../../web/src/app/studio_services";
import { FIRST_VISIT } from "../../../web/src/app/ui_state";
import { model as bunch } from "../../../web/src/models/bunch/index";
import type { BunchContext } from "../../../web/src/models/bunch/ui/context";
import type { PageModel } from "../../../web/src/models/page_model";
import { EMPTY_PLANT } from "../../../web/src/plant/plant";
import type { Specimen } from "../../../web/src/specimen/specimen";
import type { EditorContext } from "../../../web/src/ui/editor_context";

export const bunchModel = bunch as unknown as PageModel;

/** A studio with a specimen and its model's tools, and its mocked services. */
export async function studioWith(specimen: Specimen, model: PageModel = bunchModel, ui = FIRST_VISIT) {
	const services = {
		grow: vi.fn(),
		cancel: vi.fn(),
		measure: vi.fn<StudioServices["measure"]>(async () => new Float32Array()),
		growOffscreen: vi.fn<StudioServices["growOffscreen"]>(async () => EMPTY_PLANT),
		settled: vi.fn(),
		remember: vi.fn(),
	};
	const studio = new Studio({ model, specimen, ui, systemDark: false }, services);
	await vi.waitFor(() => {
		if (!studio.state.modelUi) throw new Error("The tools are not loaded yet.");
	});
	return { studio, services };
}

/** The studio as the context of the bunch's tools. */
export const bunchContext = (studio: Studio) => studio as EditorContext as unknown as BunchContext;
