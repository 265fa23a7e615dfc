import { html } from "lit";
import type { Placement } from "../photo/photo";
import type { View } from "../profile/handles";
import type { ProfileEvent } from "../profile/profile_event";
import type { BunchContext, BunchTool } from "./context";
import { changePhoto, photo } from "./photo";
import { pixels } from "./pixels";
import { sides } from "./sides";
import "../profile/profile_view";

/** One flat view of the octahedral profile with its handles. */
function profile(view: View, title: string): BunchTool {
	return { name: view, initial: undefined, editor: { title, draw: (desk) => draw(desk, view) } };
}

function draw(desk: BunchContext, view: View): unknown {
	const { specimen, grown } = desk.state;
	const laid = desk.toolState(photo);
	return html`<panicle-profile
		view=${view} .parameters=${specimen.parameters} .locks=${desk.toolState(sides)} .berries=${grown}
		.initial=${desk.preset.parameters} .pixels=${desk.toolState(pixels)} .photo=${laid?.view === view ? laid : undefined}
		@profile-input=${({ detail }: ProfileEvent) => desk.edit(detail)}
		@profile-change=${() => desk.settle()}
		@photo-input=${({ detail }: CustomEvent<Placement>) => changePhoto(desk, detail)}
	></panicle-profile>`;
}

export const front = profile("front", "Front");
export const side = profile("side", "Side");
