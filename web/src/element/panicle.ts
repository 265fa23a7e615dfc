/** The script that defines the element for a page: `<script type="module" src="…/panicle.js">`. */
import { PanicleSpecimen } from "./panicle_specimen";

export type { GrownDetail } from "./grown_detail";
export { PanicleSpecimen };

// If a page loads the script twice, the first version stays.
if (!customElements.get("panicle-specimen")) customElements.define("panicle-specimen", PanicleSpecimen);
