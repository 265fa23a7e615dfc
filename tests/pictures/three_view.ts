/** A GLB as stock three.js shows it, in the light of its own RoomEnvironment: runs in a page that Vite serves. */
import * as three from "three";
import { RoomEnvironment } from "three/addons/environments/RoomEnvironment.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const FIELD = 28;

/** @param bytes of the GLB; the picture is a PNG with nothing behind the plant, seen from in front */
export async function pictureOf(bytes: Uint8Array<ArrayBuffer>, width: number, height: number): Promise<Blob> {
	const { scene: plant } = await new GLTFLoader().parseAsync(bytes.buffer, "");
	const canvas = new OffscreenCanvas(width, height);
	const renderer = new three.WebGLRenderer({ canvas, alpha: true, antialias: true });
	const scene = new three.Scene();
	scene.environment = new three.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
	scene.add(plant);
	const box = new three.Box3().setFromObject(plant);
	const [middle, size] = [box.getCenter(new three.Vector3()), box.getSize(new three.Vector3())];
	const across = Math.max(size.y, (size.x * height) / width);
	const away = size.z / 2 + (0.54 * across) / Math.tan((FIELD * Math.PI) / 360);
	const camera = new three.PerspectiveCamera(FIELD, width / height, away / 100, 100 * away);
	camera.position.copy(middle).add(new three.Vector3(0, 0, away));
	camera.lookAt(middle);
	renderer.render(scene, camera);
	return canvas.convertToBlob({ type: "image/png" });
}
