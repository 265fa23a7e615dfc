import { html } from "lit";
import { text } from "../messages.generated";
import type { Placement } from "../photo/photo";
import type { View } from "../profile/handles";
import type { ProfileEvent } from "../profile/profile_event";
import type { BunchContext, BunchTool } from "./context";
import { changePhoto, photo } from "./photo";
import { pixels } from "./pixels";
import { sides } from "./sides";
import "../profile/profile_view";

/** Creates the tool of one flat view of the octahedral profile. */
function profile(view: View): BunchTool {
	return {
		name: view,
		initial: undefined,
		editor: {
			get title() {
				return text(view);
			},
			draw: (context) => draw(context, view),
		},
	};
}

/** Renders one view of the profile, connected to the document. */
function draw(context: BunchContext, view: View): unknown {
	const { specimen, grown } = context.state;
	const placed = context.toolState(photo);
	return html`<panicle-profile
		view=${view} .parameters=${specimen.parameters} .locks=${context.toolState(sides)} .berries=${grown}
		.initial=${context.preset.parameters} .pixels=${context.toolState(pixels)} .photo=${placed?.view === view ? placed : undefined}
		@profile-input=${({ detail }: ProfileEvent) => context.edit(detail)}
		@profile-change=${() => context.settle()}
		@photo-input=${({ detail }: CustomEvent<Placement>) => changePhoto(context, detail)}
	></panicle-profile>`;
}

export const front = profile("front");
export const side = profile("side");
