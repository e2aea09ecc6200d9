package dev.twister.oracle;

import dev.twister.mesh.Affine;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Vector3;
import java.util.Arrays;
import java.util.Optional;

/**
 * One triangle of a mesh, in scene coordinates.
 *
 * @param number the mesh's body number
 * @param corners positions with normals and texture coordinates
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record TriangleBody(int number, Corner[] corners, boolean mirrored, OracleMaterial material, OracleMaps maps)
        implements Body {
    /** A corner with its shading normal, if the mesh has normals, and its texture coordinates. */
    record Corner(Vector place, Optional<Vector> normal, double u, double v, Color color, double opacity) {}

    static TriangleBody of(
            int number,
            TriangleMesh mesh,
            int triangle,
            Affine placement,
            OracleMaterial material,
            OracleMaps maps,
            boolean colored) {
        Corner[] corners = new Corner[3];
        for (int i = 0; i < 3; i++) {
            corners[i] = corner(mesh, mesh.corners()[3 * triangle + i], placement, colored);
        }
        return new TriangleBody(number, corners, isMirrored(placement), material, maps);
    }

    private static Corner corner(TriangleMesh mesh, int vertex, Affine placement, boolean colored) {
        float[] color = colored && mesh.colors().length > 0
                ? Arrays.copyOfRange(mesh.colors(), 4 * vertex, 4 * vertex + 4)
                : new float[] {1, 1, 1, 1};
        float[] uv = mesh.textureCoordinates();
        return new Corner(
                vector(placement.point(at(mesh.positions(), vertex))),
                mesh.normals().length == 0
                        ? Optional.empty()
                        : Optional.of(turned(at(mesh.normals(), vertex), placement)),
                uv.length == 0 ? 0 : uv[2 * vertex],
                uv.length == 0 ? 0 : uv[2 * vertex + 1],
                new Color(color[0], color[1], color[2]),
                color[3]);
    }

    private static Vector3 at(float[] vectors, int vertex) {
        return new Vector3(vectors[3 * vertex], vectors[3 * vertex + 1], vectors[3 * vertex + 2]);
    }

    /** Transforms a normal to scene coordinates, keeping it perpendicular; not normalized. */
    private static Vector turned(Vector3 normal, Affine placement) {
        Vector x = vector(placement.axisX());
        Vector y = vector(placement.axisY());
        Vector z = vector(placement.axisZ());
        Vector turned = y.cross(z)
                .times(normal.x())
                .plus(z.cross(x).times(normal.y()))
                .plus(x.cross(y).times(normal.z()));
        return turned.times(1 / x.dot(y.cross(z)));
    }

    private static boolean isMirrored(Affine placement) {
        return vector(placement.axisX()).dot(vector(placement.axisY()).cross(vector(placement.axisZ()))) < 0;
    }

    private static Vector vector(Vector3 vector) {
        return new Vector(vector.x(), vector.y(), vector.z());
    }

    private Vector edge(int corner) {
        return corners[corner].place().minus(corners[0].place());
    }

    /** The outward normal by winding order; not normalized. */
    private Vector face() {
        return edge(1).cross(edge(2)).times(mirrored ? -1 : 1);
    }

    /** Returns the normal on the side that a ray comes from. */
    Vector facing(Ray ray) {
        return ray.direction().dot(face()) > 0 ? face().times(-1) : face();
    }

    /** Whether a ray starts in the triangle's plane, as exactly as floats place it: it leaves a coincident surface. */
    private boolean startsInPlane(Ray ray) {
        Vector fromCorner = ray.origin().minus(corners[0].place());
        double size = ray.origin().length() + corners[0].place().length();
        return Math.abs(face().normalized().dot(fromCorner)) <= 0x1p-22 * size;
    }

    /** Intersects from either side (Moeller and Trumbore 1997). */
    @Override
    public double distance(Ray ray) {
        Vector across = ray.direction().cross(edge(2));
        double determinant = edge(1).dot(across);
        Vector fromCorner = ray.origin().minus(corners[0].place());
        double b = fromCorner.dot(across) / determinant;
        Vector along = fromCorner.cross(edge(1));
        double c = ray.direction().dot(along) / determinant;
        double distance = edge(2).dot(along) / determinant;
        boolean met = b >= 0 && c >= 0 && b + c <= 1 && distance > 0 && !startsInPlane(ray);
        return met && !(maps.cuts() && opacity(ray.at(distance)) < maps.alpha().cutoff()) ? distance : MISS;
    }

    /** A ray never hits the triangle that it leaves. */
    @Override
    public double distanceInside(Ray ray) {
        return MISS;
    }

    /** Returns the barycentric weight of the second or the third corner. */
    private double part(Vector point, int corner) {
        Vector face = edge(1).cross(edge(2));
        Vector away = point.minus(corners[0].place());
        Vector product = corner == 1 ? away.cross(edge(2)) : edge(1).cross(away);
        return product.dot(face) / face.dot(face);
    }

    private double between(Vector point, double a, double b, double c) {
        return a + part(point, 1) * (b - a) + part(point, 2) * (c - a);
    }

    @Override
    public Vector normal(Vector point) {
        return corners[0].normal().isEmpty() ? face().normalized() : interpolated(point);
    }

    private Vector interpolated(Vector point) {
        Vector a = corners[0].normal().orElseThrow();
        Vector b = corners[1].normal().orElseThrow();
        Vector c = corners[2].normal().orElseThrow();
        return new Vector(
                        between(point, a.x(), b.x(), c.x()),
                        between(point, a.y(), b.y(), c.y()),
                        between(point, a.z(), b.z(), c.z()))
                .normalized();
    }

    @Override
    public Vector normal(Ray ray, Vector point) {
        Vector normal = normal(point);
        Vector outward = normal.dot(face()) < 0 ? normal.times(-1) : normal;
        Vector turned = maps.turned(outward, toRight(), upward(), u(point), v(point));
        Vector near = ray.direction().dot(face()) > 0 ? turned.times(-1) : turned;
        return maps.normal().isEmpty()
                ? near
                : OracleMaps.facing(near, ray.direction().times(-1));
    }

    @Override
    public boolean isMetFromInside(Ray ray, Vector normal) {
        return material.transmits() && ray.direction().dot(face()) > 0;
    }

    @Override
    public Vector face(Ray ray, Vector point) {
        return facing(ray).normalized();
    }

    @Override
    public boolean emits(Ray ray, boolean fromInside) {
        return (material.emits() || maps.unlit())
                && (material.emitsInward() || ray.direction().dot(face()) < 0);
    }

    private double u(Vector point) {
        return between(point, corners[0].u(), corners[1].u(), corners[2].u());
    }

    private double v(Vector point) {
        return between(point, corners[0].v(), corners[1].v(), corners[2].v());
    }

    /** The direction in which u grows and v does not: what is added to u along an edge is what is left of v. */
    private Vector toRight() {
        return edge(1).times(corners[2].v() - corners[0].v())
                .minus(edge(2).times(corners[1].v() - corners[0].v()))
                .times(Math.signum(imageArea()));
    }

    /** The direction in which v falls and u stays. */
    private Vector upward() {
        return edge(1).times(corners[2].u() - corners[0].u())
                .minus(edge(2).times(corners[1].u() - corners[0].u()))
                .times(Math.signum(imageArea()));
    }

    private double imageArea() {
        return (corners[1].u() - corners[0].u()) * (corners[2].v() - corners[0].v())
                - (corners[2].u() - corners[0].u()) * (corners[1].v() - corners[0].v());
    }

    private double vertexOpacity(Vector point) {
        return between(point, corners[0].opacity(), corners[1].opacity(), corners[2].opacity());
    }

    double opacity(Vector point) {
        return maps.opacity(u(point), v(point), vertexOpacity(point));
    }

    private Color base(Vector point) {
        Color vertex = new Color(
                between(
                        point,
                        corners[0].color().red(),
                        corners[1].color().red(),
                        corners[2].color().red()),
                between(
                        point,
                        corners[0].color().green(),
                        corners[1].color().green(),
                        corners[2].color().green()),
                between(
                        point,
                        corners[0].color().blue(),
                        corners[1].color().blue(),
                        corners[2].color().blue()));
        return material.textured(material.color().times(vertex), u(point), v(point));
    }

    @Override
    public Color albedo(Vector point) {
        return maps.unlit() ? Color.BLACK : base(point);
    }

    @Override
    public Color passing(Vector point) {
        return maps.blends() ? new Color(1, 1, 1) : albedo(point);
    }

    @Override
    public double open(Vector point) {
        return maps.open(u(point), v(point));
    }

    @Override
    public OracleMaterial material(Vector point) {
        OracleMaterial varied = maps.at(material, u(point), v(point), vertexOpacity(point));
        return maps.unlit() ? varied.withEmission(base(point)) : varied;
    }
}
