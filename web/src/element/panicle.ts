/** The one script of a page that shows plants: `<script type="module" src="…/panicle.js">`. */
import { PanicleSpecimen } from "./panicle_specimen";

export type { GrownDetail } from "./grown_detail";
export { PanicleSpecimen };

// A page that has the script twice, in two versions perhaps, keeps the first.
if (!customElements.get("panicle-specimen")) customElements.define("panicle-specimen", PanicleSpecimen);
