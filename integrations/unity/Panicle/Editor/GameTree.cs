using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using UnityEngine;
using UnityEngine.Rendering;

namespace Panicle.Editor
{
    /// <summary>
    /// Sets up an instance of an imported game tree: a LODGroup, materials with wind, convex colliders, and the impostor.
    /// </summary>
    public static class GameTree
    {
        /// <summary>The least share of the view's height at which each level is drawn; the last tree is culled below 1 %.</summary>
        static readonly float[] ScreenSizes = { 0.75f, 0.26f, 0.085f };

        const float CullSize = 0.01f;

        /// <summary>The share of a level's range over which it fades to the next level.</summary>
        const float FadeWidth = 0.15f;

        static readonly Regex LevelName = new Regex(@"_LOD(\d)$");

        /// <summary>Returns the levels of an object by their numbers; none if it is not a game tree.</summary>
        public static SortedDictionary<int, Transform> LevelsOf(GameObject root)
        {
            var levels = new SortedDictionary<int, Transform>();
            foreach (var child in root.GetComponentsInChildren<Transform>(true))
            {
                var found = LevelName.Match(child.name);
                if (found.Success) levels[int.Parse(found.Groups[1].Value)] = child;
            }
            return levels;
        }

        /// <summary>Sets up a tree.</summary>
        /// <param name="root">an instance of the imported GLB</param>
        /// <param name="impostor">the material of the impostor, or null</param>
        /// <param name="description">the JSON beside the GLB, or null</param>
        /// <param name="materials">receives each new material, which the caller stores</param>
        public static void SetUp(
            GameObject root, Material impostor, TreeDescription description, ICollection<Material> materials)
        {
            var levels = LevelsOf(root);
            var hasImpostor = impostor != null && description != null;
            if (hasImpostor && levels.Count > 1)
            {
                // The last level shows the same pictures without a shader.
                var last = levels.Last();
                levels.Remove(last.Key);
                Object.DestroyImmediate(last.Value.gameObject);
            }
            var height = levels.Values.First().GetComponentsInChildren<Renderer>(true).Max(each => each.bounds.max.y);
            var replaced = new Dictionary<Material, Material>();
            var lods = new List<LOD>();
            foreach (var level in levels.Values)
            {
                var renderers = level.GetComponentsInChildren<Renderer>(true);
                foreach (var renderer in renderers)
                {
                    renderer.sharedMaterials = renderer.sharedMaterials
                        .Select(each => Replaced(each, height, replaced))
                        .ToArray();
                }
                lods.Add(new LOD(SizeAfter(lods.Count, description), renderers) { fadeTransitionWidth = FadeWidth });
            }
            foreach (var material in replaced.Values) materials.Add(material);
            if (hasImpostor)
                lods.Add(new LOD(CullSize, new[] { AddImpostor(root, impostor, description) }));
            else
                lods[lods.Count - 1] = new LOD(CullSize, lods[lods.Count - 1].renderers);
            var group = root.AddComponent<LODGroup>();
            group.fadeMode = LODFadeMode.CrossFade;
            group.SetLODs(lods.ToArray());
            group.RecalculateBounds();
            AddColliders(root);
        }

        /// <summary>Returns the least share of the view's height of a level; the description has shares of its area.</summary>
        static float SizeAfter(int level, TreeDescription description)
        {
            var described = description == null ? null : description.levels;
            if (described != null && level < described.Length && described[level].screenCoverage > 0)
                return Mathf.Sqrt(described[level].screenCoverage);
            return ScreenSizes[Mathf.Min(level, ScreenSizes.Length - 1)];
        }

        /// <summary>Returns the material with wind for one that glTFast made; the same one for the same material.</summary>
        static Material Replaced(Material old, float height, IDictionary<Material, Material> known)
        {
            if (old == null) return null;
            if (known.TryGetValue(old, out var material)) return material;
            material = new Material(Shader.Find("Panicle/Tree")) { name = old.name };
            var isLeaf = old.HasProperty("alphaCutoff") && old.IsKeywordEnabled("_ALPHATEST_ON");
            if (old.HasProperty("baseColorTexture")) material.SetTexture("_BaseMap", old.GetTexture("baseColorTexture"));
            if (old.HasProperty("baseColorFactor")) material.SetColor("_BaseColor", old.GetColor("baseColorFactor"));
            if (old.HasProperty("normalTexture") && old.GetTexture("normalTexture") != null)
                material.SetTexture("_BumpMap", old.GetTexture("normalTexture"));
            material.SetFloat("_Cutoff", isLeaf ? old.GetFloat("alphaCutoff") : 0f);
            material.SetFloat("_Translucency", isLeaf ? 0.4f : 0f);
            material.SetFloat("_Cull", (float)(isLeaf ? CullMode.Off : CullMode.Back));
            material.SetFloat("_TreeHeight", height);
            material.enableInstancing = true;
            known[old] = material;
            return material;
        }

        /// <summary>Adds a square that the shader turns towards the camera.</summary>
        static Renderer AddImpostor(GameObject root, Material material, TreeDescription description)
        {
            var child = new GameObject(root.name + "_Impostor");
            child.transform.SetParent(root.transform, false);
            var radius = description.impostor.radius;
            // glTFast mirrors X: glTF is right-handed.
            var centre = new Vector3(-description.impostor.middle[0], description.impostor.middle[1], description.impostor.middle[2]);
            var mesh = new Mesh
            {
                name = child.name,
                vertices = new[] { new Vector3(-1, -1), new Vector3(1, -1), new Vector3(-1, 1), new Vector3(1, 1) },
                triangles = new[] { 0, 2, 1, 1, 2, 3 },
                // The shader moves the corners: these bounds contain the square in all directions.
                bounds = new Bounds(centre, 2 * radius * Vector3.one),
            };
            child.AddComponent<MeshFilter>().sharedMesh = mesh;
            var renderer = child.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = material;
            material.SetVector("_Centre", centre);
            material.SetFloat("_Radius", radius);
            material.SetFloat("_Frames", description.impostor.frames);
            return renderer;
        }

        /// <summary>Replaces the shapes UCX_… by convex colliders.</summary>
        static void AddColliders(GameObject root)
        {
            foreach (var filter in root.GetComponentsInChildren<MeshFilter>(true))
            {
                if (!filter.name.StartsWith("UCX_")) continue;
                var collider = filter.gameObject.AddComponent<MeshCollider>();
                collider.sharedMesh = filter.sharedMesh;
                collider.convex = true;
                Object.DestroyImmediate(filter.GetComponent<MeshRenderer>());
                Object.DestroyImmediate(filter);
            }
        }
    }
}
