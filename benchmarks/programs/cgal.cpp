// CGAL's smoothed-rotation ARAP on a mesh with held vertices: deform MESH.off HELD ITERATIONS OUT
// HELD: a line "vertex x y z" for each held vertex and where it goes.
// Prints the seconds of the preprocessing and of one iteration; OUT gets a line "x y z" a vertex.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <chrono>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Deformation = CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, CGAL::SRE_ARAP>;
using Clock = std::chrono::steady_clock;

static double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: deform MESH.off HELD ITERATIONS OUT\n";
        return 2;
    }
    Mesh mesh;
    if (!CGAL::IO::read_OFF(argv[1], mesh)) {
        std::cerr << argv[1] << ": not a manifold OFF mesh\n";
        return 2;
    }
    std::vector<std::pair<Mesh::Vertex_index, Point>> held;
    std::ifstream targets(argv[2]);
    for (std::size_t vertex; targets >> vertex;) {
        double x, y, z;
        targets >> x >> y >> z;
        held.emplace_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(vertex)), Point(x, y, z));
    }
    const unsigned iterations = static_cast<unsigned>(std::stoul(argv[3]));
    auto start = Clock::now();
    Deformation deformation(mesh);
    deformation.insert_roi_vertices(vertices(mesh).first, vertices(mesh).second);
    for (const auto& [vertex, target] : held) {
        deformation.insert_control_vertex(vertex);
    }
    if (!deformation.preprocess()) {
        std::cerr << "preprocessing failed\n";
        return 1;
    }
    const double preprocessing = since(start);
    for (const auto& [vertex, target] : held) {
        deformation.set_target_position(vertex, target);
    }
    start = Clock::now();
    deformation.deform(iterations, 0.0);
    std::cout << preprocessing << ' ' << since(start) / iterations << '\n';
    std::ofstream out(argv[4]);
    out << std::setprecision(17);
    for (const auto vertex : mesh.vertices()) {
        out << mesh.point(vertex) << '\n';
    }
}
