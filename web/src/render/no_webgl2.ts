import { text } from "./messages.generated";

/** Error: the browser has no WebGL 2; the message is for the user. */
export class NoWebGL2Error extends Error {
	constructor(options?: ErrorOptions) {
		super(text("no_webgl2"), options);
		this.name = "NoWebGL2Error";
	}
}
