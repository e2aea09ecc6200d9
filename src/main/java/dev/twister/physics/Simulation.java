package dev.twister.physics;

import dev.twister.kernel.Layout;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Simulates a scene's spheres in steps of fixed length, independent of the frame rate. The same scene gives bitwise
 * identical results after the same number of steps, in every run and with any number of threads. Only one thread at a
 * time may use it.
 *
 * <p>No sphere passes through the ground or a wall at any speed. Spheres do not pass through each other up to the speed
 * limit of {@value #MAX_SPEED} m/s; a sphere that is hit and then moves more than its diameter in one
 * {@value #MAX_PARTS}th of a step may pass through a third sphere within that step. A sphere that falls off the plane
 * stops {@value #DEPTH} meters away from everything that the scene started with.
 */
public final class Simulation implements AutoCloseable {
    /** Length of a step in seconds. */
    public static final double STEP_SECONDS = 1.0 / 120;

    /** Speed limit in m/s. */
    public static final double MAX_SPEED = 500;

    /** Most parts of a step; fast scenes have more parts, and each part has one search for contacts. */
    static final int MAX_PARTS = 8;

    static final int SUBSTEPS = 4;
    private static final double DEPTH = 1000;
    /** With fewer bodies, threads cost more than they save. */
    private static final int MIN_BODIES_FOR_THREADS = 2500;

    private static final int REORDER_STEPS = 16;

    /** Relative distance beyond its radius within which a resting body's neighbors are searched. */
    private static final double MARGIN = 0.05;

    private static final double TYPICAL_SHARE = 0.99;

    /** Displacement of a triangle in a step that wakes bodies, in their radii. */
    private static final double LEAST_DRIFT = 1e-5;

    /** Elapsed times are rounded sums: a time short of a step by less than this counts as a full step. */
    private static final double ROUNDING = 1e-9;

    private final BodyStore bodies;
    private final Surroundings surroundings;
    private final Team team;
    private final int threads;
    private final int firstBody;
    private final ContactSearch search;
    private final ContactSolver solver;
    private final LoadBalancing bracing;
    private final VerletIntegrator integrator;
    private final PourRelease spout;
    private final BodyPasses survey;
    private final double limit;
    private final double filmStart;
    private Scene scene;
    private double substep;
    private long steps;
    private double ahead;

    private Simulation(Scene scene, MeshCollider mesh, int threads, double filmStart) {
        this.filmStart = filmStart;
        this.scene = scene;
        this.threads = threads;
        List<Sphere> spheres = scene.allSpheres();
        int placed = scene.spheres().size();
        bodies = new BodyStore(scene, spheres);
        surroundings = Surroundings.of(scene, mesh);
        team = new Team(spheres.size() < MIN_BODIES_FOR_THREADS ? 1 : threads);
        firstBody = scene.physics().solidLight() ? BodyStore.FIRST_LIGHT : bodies.firstSphere;
        search = new ContactSearch(bodies, surroundings, team, firstBody, typicalRadius(spheres) * (1 + 2 * MARGIN));
        solver = ContactSolver.moving(bodies, surroundings);
        bracing = new LoadBalancing(bodies, surroundings);
        integrator = new VerletIntegrator(bodies, surroundings);
        survey = new BodyPasses(bodies, team, firstBody);
        spout = PourRelease.of(scene.pour(), spheres.subList(placed, spheres.size()));
        limit = Math.max(largestCoordinate(scene, spheres), mesh.largestCoordinate()) + DEPTH;
        setSubstep(STEP_SECONDS / SUBSTEPS);
        Vector3 gravity = surroundings.gravity();
        for (Sphere sphere : scene.spheres()) {
            bodies.add(sphere.position(), sphere.radius());
            bodies.setMove(
                    bodies.count - 1,
                    integrator.moveBefore(0, gravity.x()),
                    integrator.moveBefore(0, gravity.y()),
                    integrator.moveBefore(0, gravity.z()));
        }
    }

    /** The scene at time 0, simulated on all cores, with meshes at rest. */
    public static Simulation of(Scene scene, SceneMeshes meshes) {
        return of(scene, meshes, Runtime.getRuntime().availableProcessors());
    }

    /**
     * The scene at time 0, simulated on all cores, with meshes that move by their animations and tracks.
     *
     * @param filmStart the simulated time at which they begin to move, in seconds
     */
    public static Simulation ofFilm(Scene scene, SceneMeshes meshes, double filmStart) {
        MeshCollider mesh = MeshCollider.ofFilm(scene, meshes);
        return new Simulation(scene, mesh, Runtime.getRuntime().availableProcessors(), filmStart);
    }

    /**
     * A scene without meshes at time 0.
     *
     * @throws IllegalArgumentException if the scene has meshes
     */
    public static Simulation of(Scene scene) {
        return of(scene, SceneMeshes.NONE);
    }

    /**
     * The scene at time 0.
     *
     * @param meshes the meshes that the scene refers to
     * @param threads number of threads, at least 1; small scenes use only one
     * @throws IllegalArgumentException if one of the scene's meshes is missing
     */
    public static Simulation of(Scene scene, SceneMeshes meshes, int threads) {
        return of(scene, MeshCollider.of(scene, meshes), threads);
    }

    static Simulation of(Scene scene, MeshCollider mesh, int threads) {
        return new Simulation(scene, mesh, threads, 0);
    }

    /**
     * Continues after an edit of the scene. Returns this simulation if the edit does not affect the motion; otherwise
     * closes it and returns a new one. A sphere that is in both scenes ({@link SameSpheres}) and that the edit did not
     * move keeps its position and velocity, and so do poured spheres if the pour is the same. New and moved spheres
     * start at rest. Sleeping spheres wake up, because their support may be gone.
     *
     * @param meshes the meshes that the edited scene refers to
     */
    public Simulation goOnIn(Scene edited, SceneMeshes meshes) {
        boolean sameMeshes = haveMeshesAlike(scene, edited);
        if (sameMeshes && movesAlike(scene, edited)) {
            scene = edited;
            // Lights that are not solid may have moved, without effect on the motion.
            bodies.putLights(edited.lights());
            return this;
        }
        MeshCollider mesh = sameMeshes ? surroundings.mesh() : MeshCollider.of(edited, meshes);
        Simulation next = of(edited, mesh, threads);
        next.takeOver(this);
        close();
        return next;
    }

    /** Whether the meshes are the same, apart from their materials. */
    private static boolean haveMeshesAlike(Scene one, Scene other) {
        return places(one).equals(places(other));
    }

    private static List<Mesh> places(Scene scene) {
        return scene.meshes().stream().map(Mesh::withoutMaterial).toList();
    }

    private static boolean movesAlike(Scene one, Scene other) {
        return one.physics().equals(other.physics())
                && one.lights().placed().size() == other.lights().placed().size()
                && one.lights().first().isSun() == other.lights().first().isSun()
                && (!one.physics().solidLight()
                        || areAlike(one.lights().placed(), other.lights().placed()))
                && one.ground().size() == other.ground().size()
                && one.ground().height() == other.ground().height()
                && one.pour().equals(other.pour())
                && moveAlike(one.spheres(), other.spheres());
    }

    private static boolean areAlike(List<Light> some, List<Light> others) {
        return IntStream.range(0, some.size())
                .allMatch(index ->
                        some.get(index).position().equals(others.get(index).position())
                                && some.get(index).radius() == others.get(index).radius());
    }

    private static boolean moveAlike(List<Sphere> some, List<Sphere> others) {
        return some.size() == others.size()
                && IntStream.range(0, some.size())
                        .allMatch(index -> SameSpheres.isSamePlace(some.get(index), others.get(index))
                                && some.get(index).radius() == others.get(index).radius());
    }

    private void takeOver(Simulation old) {
        List<Sphere> before = old.scene.spheres();
        List<Sphere> now = scene.spheres();
        int[] bodyOfSphere = old.bodies.bodiesOfSpheres();
        int[] same = SameSpheres.of(before, now);
        for (int index = 0; index < same.length; index++) {
            if (same[index] != SameSpheres.NONE && SameSpheres.isSamePlace(before.get(same[index]), now.get(index))) {
                takeOver(old, bodyOfSphere[same[index]], bodies.firstSphere + index);
            }
        }
        ahead = old.ahead;
        if (scene.pour().equals(old.scene.pour())) {
            steps = old.steps;
            int poured = old.bodies.count - old.bodies.firstSphere - before.size();
            spout.skip(poured, bodies);
            for (int index = 0; index < poured; index++) {
                takeOver(old, bodyOfSphere[before.size() + index], bodies.firstSphere + now.size() + index);
            }
        }
    }

    private void takeOver(Simulation old, int from, int body) {
        bodies.putWhere(body, old.bodies, from);
        Vector3 gravity = surroundings.gravity();
        bodies.setMove(
                body,
                integrator.moveBefore(old.velocity(from, 0), gravity.x()),
                integrator.moveBefore(old.velocity(from, 1), gravity.y()),
                integrator.moveBefore(old.velocity(from, 2), gravity.z()));
    }

    /** The approximate number of steps for a duration. */
    public static int stepsIn(double seconds) {
        return (int) Math.round(seconds / STEP_SECONDS);
    }

    /** Simulates a duration of 0 or more seconds: takes as many steps as fit, and keeps the rest for the next call. */
    public void advance(double seconds) {
        advance(seconds, () -> {});
    }

    /**
     * As above, for calls that may take minutes.
     *
     * @param stepped called after each step, about {@link #stepsIn} times
     */
    public void advance(double seconds, Runnable stepped) {
        ahead += seconds;
        while (ahead >= STEP_SECONDS - ROUNDING) {
            step();
            ahead = Math.max(0, ahead - STEP_SECONDS);
            stepped.run();
        }
    }

    /** Takes one step, and advances {@link #positions} by one step too; later calls continue from there. */
    public void stepOnce() {
        step();
        if (ahead == 0) {
            // Otherwise positions() would return the start of the new step.
            ahead = STEP_SECONDS;
        }
    }

    /** Takes one step. */
    public void step() {
        double longest = survey.begin(limit);
        double now = steps * STEP_SECONDS;
        spout.open(now, now + STEP_SECONDS, bodies, integrator, surroundings.gravity());
        steps++;
        MeshCollider mesh = surroundings.mesh();
        double drift = mesh.begin(Math.max(0, steps * STEP_SECONDS - filmStart));
        if (longest >= 0 || spout.isOpen() || drift > 0) {
            int parts = parts(Math.max(Math.sqrt(Math.max(0, longest)) / substep, drift / STEP_SECONDS));
            if (drift > 0) {
                inChunks(this::rouseOnMesh);
                mesh.divide(parts * SUBSTEPS);
            }
            changeSubstep(STEP_SECONDS / (parts * SUBSTEPS));
            for (int part = 0; part < parts; part++) {
                movePart();
            }
            if (steps % REORDER_STEPS == 0 && bodies.count > MIN_BODIES_FOR_THREADS) {
                search.reorder();
            }
            double strength = surroundings.gravityStrength();
            inChunks((from, to) -> Rest.settle(bodies, from, to, strength, STEP_SECONDS));
        }
    }

    /** The simulated time of all steps, in seconds. */
    public double seconds() {
        return steps * STEP_SECONDS;
    }

    /**
     * Number of present bodies, including the first light and the plane; spheres that are not poured yet do not count.
     */
    public int bodies() {
        return bodies.count - bodies.firstSphere + Layout.FIRST_SPHERE;
    }

    /**
     * The bodies' positions in a new array, interpolated between the last two steps by the remaining time; the picture
     * is less than a step behind.
     *
     * @return {@code float[3 * room]}, as {@link World#setBodyPositions} takes it, for a world with the scene's origin
     */
    public float[] positions() {
        return positions(Vector3.ZERO);
    }

    /**
     * As above, relative to another origin.
     *
     * @param origin in the scene's coordinates, in meters; {@link World#origin} for a world's bodies
     */
    public float[] positions(Vector3 origin) {
        float share = (float) (ahead / STEP_SECONDS);
        float[] positions = new float[3 * (bodies.state.length - bodies.firstSphere + Layout.FIRST_SPHERE)];
        double[] start = {origin.x(), origin.y(), origin.z()};
        positions[3 * Layout.PLANE] = (float) (0 - origin.x());
        positions[3 * Layout.PLANE + 1] = (float) (surroundings.height() - origin.y());
        positions[3 * Layout.PLANE + 2] = (float) (0 - origin.z());
        if (!scene.lights().first().isSun()) {
            put(BodyStore.FIRST_LIGHT, start, positions, Layout.LIGHT, 1);
        }
        inChunks((from, to) -> {
            for (int body = Math.max(from, bodies.firstSphere); body < to; body++) {
                put(body, start, positions, Layout.FIRST_SPHERE + bodies.sphere[body], share);
            }
        });
        return positions;
    }

    /** Moves the bodies of a world of the same scene to their positions here. */
    public void place(World world) {
        world.setBodyPositions(positions(world.origin()), bodies());
    }

    /** Stops the threads. */
    @Override
    public void close() {
        team.close();
    }

    BodyStore store() {
        return bodies;
    }

    /** A body's velocity along an axis at the end of the last step, in m/s, if only gravity acts on it. */
    double velocity(int body, int axis) {
        Vector3 gravity = surroundings.gravity();
        double pull = axis == 0 ? gravity.x() : axis == 1 ? gravity.y() : gravity.z();
        return bodies.numbers[BodyStore.STRIDE * body + BodyStore.MOVE + axis] / substep + pull * substep / 2;
    }

    private void movePart() {
        double moves = SUBSTEPS;
        double seconds = SUBSTEPS * substep;
        double fall = surroundings.gravityStrength() * seconds * seconds;
        double[] bounds = survey.reach(MARGIN, moves, fall);
        boolean anyJustWoken = survey.anyJustWoken();
        search.search(bounds, anyJustWoken);
        Columns columns = search.columns();
        if (anyJustWoken) {
            bracing.load(search);
        }
        inChunks(integrator::accelerate);
        if (anyJustWoken) {
            bracing.brace(search);
        }
        for (int sub = 1; sub <= SUBSTEPS; sub++) {
            for (int color = 0; color < Columns.COLORS; color++) {
                int own = color;
                team.each(columns.rows(color), index -> solveRow(columns.row(own, index)));
            }
            solver.solve(search.giantsContacts(), 0, search.giantsContacts().count);
            inChunks(sub < SUBSTEPS ? this::moveAndAccelerate : integrator::move);
            surroundings.mesh().advance();
        }
    }

    /** Wakes sleeping bodies on triangles that move. */
    private void rouseOnMesh(int from, int to) {
        double[] n = bodies.numbers;
        for (int body = Math.max(from, bodies.firstSphere); body < to; body++) {
            int at = BodyStore.STRIDE * body;
            double radius = n[at + BodyStore.RADIUS];
            if (bodies.state[body] == BodyStore.ASLEEP
                    && surroundings
                            .mesh()
                            .isMovingNear(n[at], n[at + 1], n[at + 2], (1 + MARGIN) * radius, LEAST_DRIFT * radius)) {
                bodies.rouse(body);
            }
        }
    }

    // Both while the chunk's bodies are cached.
    private void moveAndAccelerate(int from, int to) {
        integrator.move(from, to);
        integrator.accelerate(from, to);
    }

    private void solveRow(int row) {
        Columns columns = search.columns();
        Contacts contacts = search.contacts(row);
        int first = columns.firstOfRow(row);
        int from = 0;
        for (int column = first; column < first + columns.columnsInRow(); column++) {
            int to = search.end(column);
            solver.solve(contacts, from, to);
            from = to;
        }
    }

    // Powers of two, so that a fluctuating speed rarely changes the sub-steps.
    private int parts(double speed) {
        double diameters = speed * STEP_SECONDS / (2 * bodies.smallestRadius());
        int parts = 1;
        while (parts < MAX_PARTS && parts < diameters) {
            parts *= 2;
        }
        return parts;
    }

    private void changeSubstep(double seconds) {
        if (seconds != substep) {
            double old = substep;
            setSubstep(seconds);
            inChunks((from, to) -> integrator.rescale(from, to, old));
            search.scaleImpulses(seconds * seconds / (old * old));
        }
    }

    private void setSubstep(double seconds) {
        substep = seconds;
        solver.setSubstep(seconds);
        bracing.setSubstep(seconds);
        integrator.setSubstep(seconds);
    }

    private void inChunks(Team.Range work) {
        team.inChunks(firstBody, bodies.count, BodyPasses.BODIES_AT_ONCE, work);
    }

    private void put(int body, double[] origin, float[] positions, int place, float share) {
        for (int axis = 0; axis < 3; axis++) {
            double before = bodies.before[3 * body + axis];
            double now = bodies.numbers[BodyStore.STRIDE * body + BodyStore.POSITION + axis];
            positions[3 * place + axis] = (float) (before + (now - before) * share - origin[axis]);
        }
    }

    /**
     * A radius that nearly all spheres do not exceed: cells sized for a few larger ones would be too wide for the
     * others.
     */
    private static double typicalRadius(List<Sphere> spheres) {
        double[] radii = spheres.stream().mapToDouble(Sphere::radius).sorted().toArray();
        return radii.length == 0 ? 1 : radii[(int) (TYPICAL_SHARE * (radii.length - 1))];
    }

    private static double largestCoordinate(Scene scene, List<Sphere> spheres) {
        double largest =
                Math.max(scene.ground().size() / 2, Math.abs(scene.ground().height()));
        for (Sphere sphere : spheres) {
            Vector3 place = sphere.position();
            largest = Math.max(
                    largest, Math.max(Math.abs(place.x()), Math.max(Math.abs(place.y()), Math.abs(place.z()))));
        }
        return largest;
    }
}
