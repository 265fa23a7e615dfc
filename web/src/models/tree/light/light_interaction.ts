/** Shows the light in a crown's cells in the 3-D view, with a point for each cell. */
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import type { EditorContext, EditorState } from "../../../ui/editor_context";
import type { ToolInteraction, ToolView } from "../../../ui/tool";
import type { TreeSpecimen } from "../specimen";
import type { TreePlant } from "../tree_plant";
import { type LightGrid, lightPoints } from "./light_grid";
import type { LightTool } from "./light_tool";

/** Width of a point relative to a cell. */
const WIDTH = 1;
/** Render order: after the plant. */
const ORDER = 10;

export class LightHands implements ToolInteraction<TreeSpecimen, TreePlant> {
	readonly #view: ToolView;
	readonly #context: EditorContext<TreeSpecimen, TreePlant>;
	readonly #tool: LightTool;
	readonly #material = new PointsMaterial({
		vertexColors: true,
		transparent: true,
		depthTest: false, // Leaves would hide the cells between them.
		depthWrite: false,
		toneMapped: false,
	});
	readonly #points = new Points(new BufferGeometry(), this.#material);
	#shown: LightGrid | undefined;

	constructor(view: ToolView, context: EditorContext<TreeSpecimen, TreePlant>, tool: LightTool) {
		this.#view = view;
		this.#context = context;
		this.#tool = tool;
		this.#points.name = "light";
		this.#points.renderOrder = ORDER;
		this.#points.visible = false;
		view.addOverlay(this.#points, true);
	}

	/** Shows or hides the points. Previews have no light: no points are shown until the plant itself has grown. */
	update({ grown }: EditorState<TreeSpecimen, TreePlant>): void {
		const grid = this.#context.toolState(this.#tool) ? grown?.light : undefined;
		if (grid && grid !== this.#shown) this.#show(grid);
		if (!grid && !this.#points.visible) return;
		this.#points.visible = grid !== undefined;
		this.#view.requestRender();
	}

	/** Removes the points from the view. */
	dispose(): void {
		this.#view.removeOverlay(this.#points);
		this.#points.geometry.dispose();
		this.#material.dispose();
	}

	/** Replaces the points. Their size is that of the cells, in metres. */
	#show(grid: LightGrid): void {
		const { positions, colours } = lightPoints(grid);
		this.#points.geometry.dispose();
		this.#points.geometry = new BufferGeometry()
			.setAttribute("position", new BufferAttribute(positions, 3))
			.setAttribute("color", new BufferAttribute(colours, 4));
		// Point sizes ignore the field of view: cot(fov / 2), an element of the camera's projection matrix, corrects
		// this.
		this.#material.size = WIDTH * grid.edge * this.#view.camera.projectionMatrix.elements[5];
		this.#shown = grid;
	}
}
