/** Error: the browser has no WebGL 2; the message is for the user. */
export class NoWebGL2Error extends Error {
	constructor(options?: ErrorOptions) {
		super(
			"This browser cannot draw the plant: it offers no WebGL 2. Turn on hardware acceleration in its settings, or open the page in a recent Chrome, Edge, Firefox or Safari.",
			options,
		);
		this.name = "NoWebGL2Error";
	}
}
