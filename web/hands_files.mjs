/**
 * Copies the files of @mediapipe/hands, which finds hands in a camera's picture, into a folder of the built app. They are fetched when the
 * camera is switched on; the offline app does not contain them.
 */
import { copyFileSync, createReadStream, mkdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder in the built app. */
export const HANDS = "hands";

const from = fileURLToPath(new URL("../node_modules/@mediapipe/hands/", import.meta.url));
/** The files for processors with SIMD, which the cores need, too, and the smaller of the two models; with their media types. */
const FILES = {
	"hands.js": "text/javascript",
	"hands.binarypb": "application/octet-stream",
	"hand_landmark_lite.tflite": "application/octet-stream",
	"hands_solution_packed_assets_loader.js": "text/javascript",
	"hands_solution_packed_assets.data": "application/octet-stream",
	"hands_solution_simd_wasm_bin.js": "text/javascript",
	"hands_solution_simd_wasm_bin.data": "application/octet-stream",
	"hands_solution_simd_wasm_bin.wasm": "application/wasm",
};

/** @returns {import("vite").Plugin} */
export function handsFiles() {
	return {
		name: "hands-files",
		configureServer({ middlewares }) {
			middlewares.use((request, response, next) => {
				const name = new URL(request.url ?? "", "http://page").pathname.split(`/${HANDS}/`)[1];
				if (!name || !Object.hasOwn(FILES, name)) return next();
				response.setHeader("content-type", FILES[name]);
				createReadStream(join(from, name)).pipe(response);
			});
		},
		writeBundle({ dir }) {
			mkdirSync(join(dir, HANDS), { recursive: true });
			for (const name of Object.keys(FILES)) copyFileSync(join(from, name), join(dir, HANDS, name));
		},
	};
}
