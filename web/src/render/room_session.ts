/** Augmented reality by WebXR: the plant stands on a surface of the user's room, in its real size. */
import {
	Mesh,
	MeshBasicMaterial,
	PerspectiveCamera,
	RingGeometry,
	SRGBColorSpace,
	type WebGLRenderer,
	WebGLRenderTarget,
} from "three";

/** Least upward part of a surface's normal: the plant stands on floors and tables, not on walls. */
const UPRIGHT = 0.8;
/** Radii of the ring on the surface, metres. */
const RING = [0.07, 0.09] as const;
/** Nearest and farthest visible distance, metres. */
const [NEAR, FAR] = [0.02, 500];

/** The scene of a session. */
export interface RoomScene {
	/** Height of the plant's lowest point, metres. */
	readonly low: number;
	/** Draws the plant, if it has been placed, and a mark. */
	draw(three: WebGLRenderer, camera: PerspectiveCamera, mark: Mesh, isPlaced: boolean): void;
	/** The plant was placed for the first time. */
	placed?(): void;
}

/**
 * Place of the plant in the room. The plant stays at the origin of its scene; its place is the origin of the space in
 * which the device reports its position.
 */
export class RoomPlace {
	/** The space of the scene: the room's own until the plant is placed. */
	space: XRReferenceSpace;
	isPlaced = false;
	readonly #room: XRReferenceSpace;
	readonly #source: XRHitTestSource;
	readonly #low: number;
	/** The surface that the device points at, and the device, both in the room's space. */
	#surface: XRRigidTransform | undefined;
	#device: XRRigidTransform | undefined;

	/**
	 * @param room space of the room, whose y axis points up
	 * @param source finds surfaces in front of the device
	 * @param low height of the plant's lowest point, metres
	 */
	constructor(room: XRReferenceSpace, source: XRHitTestSource, low: number) {
		this.space = room;
		this.#room = room;
		this.#source = source;
		this.#low = low;
	}

	/** Reads a frame. @returns position and orientation of the surface in the scene, as a matrix; undefined without one */
	read(frame: XRFrame): Float32Array | undefined {
		const [hit] = frame.getHitTestResults(this.#source);
		const surface = hit?.getPose(this.#room)?.transform;
		this.#surface = surface && surface.matrix[5] >= UPRIGHT ? surface : undefined;
		this.#device = frame.getViewerPose(this.#room)?.transform;
		return this.#surface && hit?.getPose(this.space)?.transform.matrix;
	}

	/** Places the plant on the surface of the last frame, its front towards the device. @returns whether there is one */
	place(): boolean {
		if (!this.#surface) return false;
		const { x, y, z } = this.#surface.position;
		const eye = this.#device?.position;
		const half = eye ? 0.5 * Math.atan2(eye.x - x, eye.z - z) : 0;
		const turn = { x: 0, y: Math.sin(half), z: 0, w: Math.cos(half) };
		this.space = this.#room.getOffsetReferenceSpace(new XRRigidTransform({ x, y: y - this.#low, z }, turn));
		this.isPlaced = true;
		return true;
	}
}

/**
 * Shows a scene in the user's room until the session ends; each tap places the plant on the surface in front of the
 * device. Afterwards the renderer is as it was before. The built pages leave out three's own manager of sessions.
 * @param session with the feature `hit-test`; it is ended if an error occurs
 * @throws Error if the session cannot be drawn
 */
export async function showInRoom(session: XRSession, three: WebGLRenderer, scene: RoomScene): Promise<void> {
	const { autoClearColor } = three;
	const clearAlpha = three.getClearAlpha();
	const lifetime = new AbortController();
	const end = new Promise<void>((resolve) => {
		session.addEventListener("end", () => resolve(), { signal: lifetime.signal });
	});
	const ring = surfaceRing();
	let request = 0;
	let surface: RoomSurface | undefined;
	try {
		surface = await RoomSurface.create(session, three);
		const room = await session.requestReferenceSpace("local");
		const source = await session.requestHitTestSource?.({ space: await session.requestReferenceSpace("viewer") });
		if (!source) throw new Error("The session finds no surfaces.");
		const place = new RoomPlace(room, source, scene.low);
		const put = () => {
			const isFirst = !place.isPlaced;
			if (place.place() && isFirst) scene.placed?.();
		};
		session.addEventListener("select", put, { signal: lifetime.signal });
		// The camera's picture is visible wherever nothing is drawn.
		three.autoClearColor = true;
		three.setClearAlpha(0);
		const onto = surface;
		const draw: XRFrameRequestCallback = (_now, frame) => {
			request = session.requestAnimationFrame(draw);
			const found = place.read(frame);
			ring.visible = found !== undefined;
			if (found) ring.matrix.fromArray(found);
			ring.matrixWorldNeedsUpdate = true;
			const pose = frame.getViewerPose(place.space);
			if (pose) onto.draw(pose, (camera) => scene.draw(three, camera, ring, place.isPlaced));
		};
		request = session.requestAnimationFrame(draw);
		await end;
	} finally {
		lifetime.abort();
		session.cancelAnimationFrame(request);
		await session.end().catch(() => {}); // It has ended already, unless an error occurred.
		three.autoClearColor = autoClearColor;
		three.setClearAlpha(clearAlpha);
		surface?.dispose();
		ring.geometry.dispose();
		ring.material.dispose();
	}
}

/** The framebuffer that a session shows over the picture of the device's camera. */
class RoomSurface {
	readonly #three: WebGLRenderer;
	readonly #layer: XRWebGLLayer;
	readonly #target: WebGLRenderTarget;
	readonly #camera = new PerspectiveCamera();

	private constructor(three: WebGLRenderer, layer: XRWebGLLayer) {
		this.#three = three;
		this.#layer = layer;
		const { framebufferWidth, framebufferHeight } = layer;
		this.#target = new WebGLRenderTarget(framebufferWidth, framebufferHeight, { colorSpace: SRGBColorSpace });
		this.#target.scissorTest = true;
		// three.js then draws with tone mapping, as on a screen.
		Object.assign(this.#target, { isXRRenderTarget: true });
		this.#camera.matrixAutoUpdate = false;
	}

	/** Creates the framebuffer of a session. @throws DOMException if the graphics card cannot draw for it */
	static async create(session: XRSession, three: WebGLRenderer): Promise<RoomSurface> {
		const gl = three.getContext() as WebGL2RenderingContext;
		await gl.makeXRCompatible();
		const layer = new XRWebGLLayer(session, gl, { alpha: true });
		await session.updateRenderState({ baseLayer: layer, depthNear: NEAR, depthFar: FAR });
		return new RoomSurface(three, layer);
	}

	/** Draws all views of a frame: one on a phone, two on a headset. */
	draw({ views }: XRViewerPose, draw: (camera: PerspectiveCamera) => void): void {
		// three's types leave this method out.
		const three = this.#three as WebGLRenderer & { setRenderTargetFramebuffer(target: object, buffer: object): void };
		three.setRenderTargetFramebuffer(this.#target, this.#layer.framebuffer);
		for (const view of views) {
			const viewport = this.#layer.getViewport(view);
			if (!viewport) continue;
			const { x, y, width, height } = viewport;
			this.#target.viewport.set(x, y, width, height);
			this.#target.scissor.set(x, y, width, height);
			this.#three.setRenderTarget(this.#target);
			this.#aim(view, width / height);
			draw(this.#camera);
		}
		this.#three.setRenderTarget(null);
	}

	dispose(): void {
		this.#three.setRenderTarget(null);
		this.#target.dispose();
	}

	/** Gives the camera the position and the lens of a view. */
	#aim({ transform, projectionMatrix }: XRView, aspect: number): void {
		const camera = this.#camera;
		camera.aspect = aspect;
		camera.matrix.fromArray(transform.matrix);
		camera.matrix.decompose(camera.position, camera.quaternion, camera.scale);
		camera.projectionMatrix.fromArray(projectionMatrix);
		camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
		camera.updateMatrixWorld(true);
	}
}

/** Returns a ring that lies on the surface of its matrix. */
function surfaceRing(): Mesh<RingGeometry, MeshBasicMaterial> {
	const ring = new Mesh(
		new RingGeometry(...RING, 48).rotateX(-Math.PI / 2),
		new MeshBasicMaterial({ color: "white", toneMapped: false }),
	);
	ring.matrixAutoUpdate = false;
	ring.frustumCulled = false;
	return ring;
}
