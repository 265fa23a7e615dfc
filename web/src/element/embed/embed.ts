/**
 * The script of `embed.html?v=2&…`: shows the plant of a link in a frame, and exchanges messages with the host page.
 */
import { PanicleSpecimen } from "../panicle";
import { Conversation } from "./conversation";
import { frameSettings } from "./frame_settings";

const { link, attributes, allowed } = frameSettings(location);
const plant = new PanicleSpecimen();
plant.setAttribute("link", link);
// In a window of its own there is no page to scroll.
if (window.parent === window) plant.setAttribute("capture", "");
for (const [name, value] of attributes) plant.setAttribute(name, value);

const conversation = new Conversation(
	{
		get specimen() {
			return plant.specimen;
		},
		set: (values) => plant.set(values),
		open: (to) => {
			plant.setAttribute("link", to);
			return plant.grow();
		},
		grow: () => plant.grow(),
		toFile: (format, options) => plant.toFile(format, options),
		toBlob: (size) => plant.toBlob(size),
		resetView: () => plant.resetView(),
	},
	allowed,
);
addEventListener("message", ({ data, origin, source }) => {
	void conversation.receive({ data, origin, source: source as Window | null });
});
for (const type of ["grown", "input", "change", "error"] as const)
	plant.addEventListener(type, (event) => conversation.broadcast(type, (event as unknown as CustomEvent).detail));
document.body.append(plant);
