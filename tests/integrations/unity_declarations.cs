// Declarations of the classes of Unity that integrations/unity uses, after Unity's scripting reference, so that a
// compiler can check names and types without Unity. They do nothing.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y) { this.x = x; this.y = y; z = 0; }
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 one { get { return new Vector3(1, 1, 1); } }
        public static Vector3 operator *(float factor, Vector3 vector) { return vector; }
    }
    public struct Vector4
    {
        public static implicit operator Vector4(Vector3 vector) { return default(Vector4); }
    }
    public struct Color { }
    public struct Bounds
    {
        public Bounds(Vector3 center, Vector3 size) { max = center; }
        public Vector3 max;
    }
    public static class Mathf
    {
        public static int Min(int one, int other) { return one; }
        public static float Sqrt(float value) { return value; }
    }
    public class Object
    {
        public string name { get; set; }
        public static T Instantiate<T>(T original) where T : Object { return original; }
        public static void DestroyImmediate(Object thing) { }
        public static void DestroyImmediate(Object thing, bool allowDestroyingAssets) { }
    }
    public class Component : Object
    {
        public GameObject gameObject { get; private set; }
        public Transform transform { get; private set; }
        public T GetComponent<T>() { return default(T); }
        public T[] GetComponentsInChildren<T>(bool includeInactive) { return null; }
    }
    public sealed class Transform : Component
    {
        public void SetParent(Transform parent, bool worldPositionStays) { }
    }
    public sealed class GameObject : Object
    {
        public GameObject(string name) { }
        public Transform transform { get; private set; }
        public T AddComponent<T>() where T : Component { return null; }
        public T[] GetComponentsInChildren<T>(bool includeInactive) { return null; }
    }
    public class Texture : Object { }
    public sealed class Texture2D : Texture { }
    public sealed class Shader : Object
    {
        public static Shader Find(string name) { return null; }
    }
    public sealed class Material : Object
    {
        public Material(Shader shader) { }
        public bool enableInstancing { get; set; }
        public bool HasProperty(string name) { return false; }
        public bool IsKeywordEnabled(string name) { return false; }
        public Texture GetTexture(string name) { return null; }
        public Color GetColor(string name) { return default(Color); }
        public float GetFloat(string name) { return 0; }
        public void SetTexture(string name, Texture value) { }
        public void SetColor(string name, Color value) { }
        public void SetFloat(string name, float value) { }
        public void SetVector(string name, Vector4 value) { }
    }
    public sealed class Mesh : Object
    {
        public Vector3[] vertices { get; set; }
        public int[] triangles { get; set; }
        public Bounds bounds { get; set; }
    }
    public sealed class MeshFilter : Component
    {
        public Mesh sharedMesh { get; set; }
    }
    public class Renderer : Component
    {
        public Bounds bounds { get; private set; }
        public Material sharedMaterial { get; set; }
        public Material[] sharedMaterials { get; set; }
    }
    public sealed class MeshRenderer : Renderer { }
    public sealed class MeshCollider : Component
    {
        public Mesh sharedMesh { get; set; }
        public bool convex { get; set; }
    }
    public enum LODFadeMode { None, CrossFade, SpeedTree }
    public struct LOD
    {
        public float screenRelativeTransitionHeight, fadeTransitionWidth;
        public Renderer[] renderers;
        public LOD(float screenRelativeTransitionHeight, Renderer[] renderers)
        {
            this.screenRelativeTransitionHeight = screenRelativeTransitionHeight;
            this.renderers = renderers;
            fadeTransitionWidth = 0;
        }
    }
    public sealed class LODGroup : Component
    {
        public LODFadeMode fadeMode { get; set; }
        public void SetLODs(LOD[] lods) { }
        public void RecalculateBounds() { }
    }
    public static class JsonUtility
    {
        public static T FromJson<T>(string json) { return default(T); }
    }
    public static class Debug
    {
        public static void LogWarning(object message) { }
    }
}

namespace UnityEngine.Rendering
{
    public enum CullMode { Off, Front, Back }
}

namespace UnityEditor
{
    public class AssetPostprocessor { }
    public static class AssetDatabase
    {
        public static UnityEngine.Object[] LoadAllAssetsAtPath(string path) { return null; }
        public static T LoadAssetAtPath<T>(string path) where T : UnityEngine.Object { return null; }
        public static UnityEngine.Object[] LoadAllAssetRepresentationsAtPath(string path) { return null; }
        public static void AddObjectToAsset(UnityEngine.Object thing, string path) { }
        public static bool Contains(UnityEngine.Object thing) { return false; }
    }
    public static class PrefabUtility
    {
        public static UnityEngine.GameObject SaveAsPrefabAsset(UnityEngine.GameObject root, string path) { return root; }
    }
}
