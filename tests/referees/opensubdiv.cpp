// OpenSubdiv as referee of bicubic sheets: Catmull-Clark refinement of a net of quads, which on a regular net is the
// uniform bicubic B-spline. Reads `rows columns level` and the net's points, row by row, from the standard input; prints
// for every vertex of the refined net its position and its limit, in full precision. Vertices near the border are
// printed too: the reader takes those it asks for.
#include <cstdio>
#include <vector>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

using namespace OpenSubdiv;

struct Point {
    double at[3] = {0, 0, 0};
    void Clear(void * = nullptr) { at[0] = at[1] = at[2] = 0; }
    void AddWithWeight(Point const &other, double weight) {
        for (int i = 0; i < 3; ++i) at[i] += weight * other.at[i];
    }
};

int main() {
    int rows = 0, columns = 0, level = 0;
    if (std::scanf("%d %d %d", &rows, &columns, &level) != 3 || rows < 4 || columns < 4 || level < 1) return 2;
    std::vector<Point> points(rows * columns);
    for (Point &point : points)
        for (double &coordinate : point.at)
            if (std::scanf("%lf", &coordinate) != 1) return 2;

    std::vector<int> sizes((rows - 1) * (columns - 1), 4), corners;
    for (int i = 0; i + 1 < rows; ++i)
        for (int j = 0; j + 1 < columns; ++j)
            for (int corner : {i * columns + j, i * columns + j + 1, (i + 1) * columns + j + 1, (i + 1) * columns + j})
                corners.push_back(corner);
    Far::TopologyDescriptor net;
    net.numVertices = rows * columns;
    net.numFaces = static_cast<int>(sizes.size());
    net.numVertsPerFace = sizes.data();
    net.vertIndicesPerFace = corners.data();

    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Sdc::Options boundary;
    boundary.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    Far::TopologyRefiner *refiner = Factory::Create(net, Factory::Options(Sdc::SCHEME_CATMARK, boundary));
    if (!refiner) return 2;
    Far::TopologyRefiner::UniformOptions uniform(level);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);

    Far::PrimvarRefinerReal<double> primvar(*refiner);
    for (int step = 1; step <= level; ++step) {
        std::vector<Point> finer(refiner->GetLevel(step).GetNumVertices());
        primvar.Interpolate(step, points, finer);
        points = finer;
    }
    std::vector<Point> limits(points.size());
    primvar.Limit(points, limits);
    for (size_t i = 0; i < points.size(); ++i)
        std::printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", points[i].at[0], points[i].at[1], points[i].at[2],
                    limits[i].at[0], limits[i].at[1], limits[i].at[2]);
    delete refiner;
    return 0;
}
