#include "gltf/draco_mesh.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>

#include <cstring>
#include <optional>

namespace abflat::gltf {
namespace {

Status damaged(const std::string& reason) {
  return {StatusCode::ParseError,
          " cannot be decoded by Draco (" + reason + "). The file is damaged; export it again"};
}

/// A count in the header, which older versions write in four bytes.
bool decodeCount(draco::DecoderBuffer& buffer, bool isVarint, std::uint32_t& out) {
  return isVarint ? draco::DecodeVarint(&out, &buffer) : buffer.Decode(&out);
}

/// Sizes that the header announces for the connectivity: bytes for the corners of each corner
/// table.
struct ConnectivityHead {
  std::uint32_t faces = 0, tables = 1;

  std::size_t bytes() const { return std::size_t{faces} * tables * 3 * sizeof(std::uint32_t); }
};

/// Reads ahead in a copy of the buffer.
template <class Decoder>
std::optional<ConnectivityHead> headOf(draco::DecoderBuffer buffer, std::uint16_t version);

template <>
std::optional<ConnectivityHead> headOf<draco::MeshSequentialDecoder>(draco::DecoderBuffer buffer,
                                                                     std::uint16_t version) {
  ConnectivityHead out;
  const bool isVarint = version >= DRACO_BITSTREAM_VERSION(2, 2);
  if (!decodeCount(buffer, isVarint, out.faces)) return std::nullopt;
  return out;
}

template <>
std::optional<ConnectivityHead> headOf<draco::MeshEdgebreakerDecoder>(draco::DecoderBuffer buffer,
                                                                      std::uint16_t version) {
  ConnectivityHead out;
  const bool isVarint = version >= DRACO_BITSTREAM_VERSION(2, 0);
  std::uint32_t vertices = 0;
  std::uint8_t seams = 0;
  const bool hasNewVertices = version < DRACO_BITSTREAM_VERSION(2, 2);
  if (hasNewVertices && !decodeCount(buffer, isVarint, vertices)) return std::nullopt;
  if (!decodeCount(buffer, isVarint, vertices) || !decodeCount(buffer, isVarint, out.faces) ||
      !buffer.Decode(&seams))
    return std::nullopt;
  out.tables += seams;
  return out;
}

/// A Draco decoder that checks counts before it trusts them: the library's own allocates as many
/// faces and values as a few bytes ask for.
template <class Decoder>
class FrugalDecoder : public Decoder {
 public:
  explicit FrugalDecoder(Budget& budget) : budget_(budget) {}

  bool wantsTooMuch() const { return wantsTooMuch_; }

 protected:
  bool DecodeConnectivity() override {
    const auto head = headOf<Decoder>(*this->buffer(), this->bitstream_version());
    return head && take(head->bytes()) && Decoder::DecodeConnectivity();
  }

  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    std::size_t perPoint = 0;
    for (std::int32_t a = 0; a < cloud.num_attributes(); ++a)
      perPoint += static_cast<std::size_t>(cloud.attribute(a)->byte_stride()) + kElementAlignment;
    return take(perPoint * cloud.num_points()) && Decoder::DecodeAllAttributes();
  }

 private:
  bool take(std::size_t bytes) {
    wantsTooMuch_ = !budget_.take(bytes);
    return !wantsTooMuch_;
  }

  Budget& budget_;
  bool wantsTooMuch_ = false;
};

template <class Decoder>
Status decodeWith(draco::Mesh& mesh, draco::DecoderBuffer& buffer, Budget& budget) {
  FrugalDecoder<Decoder> decoder(budget);
  const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh);
  if (decoder.wantsTooMuch())
    return {StatusCode::ParseError, " decodes to far more than the size of the file allows"};
  return status.ok() ? Status{} : damaged(status.error_msg_string());
}

/// Values by point; false if one does not fit the type.
template <class T>
bool convert(const draco::PointAttribute& attribute, std::size_t points, std::size_t components,
             std::string& out) {
  const std::size_t size = components * sizeof(T);
  const std::size_t stride = alignedSize(size);
  out.assign(points * stride, '\0');
  std::vector<T> value(components);
  for (std::size_t p = 0; p < points; ++p) {
    const draco::AttributeValueIndex at =
        attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(p)));
    if (at.value() >= attribute.size() || !attribute.ConvertValue<T>(at, value.data()))
      return false;
    std::memcpy(&out[p * stride], value.data(), size);
  }
  return true;
}

bool convertTo(ComponentType type, const draco::PointAttribute& attribute, std::size_t points,
               std::size_t components, std::string& out) {
  switch (type) {
    case ComponentType::Int8:
      return convert<std::int8_t>(attribute, points, components, out);
    case ComponentType::Uint8:
      return convert<std::uint8_t>(attribute, points, components, out);
    case ComponentType::Int16:
      return convert<std::int16_t>(attribute, points, components, out);
    case ComponentType::Uint16:
      return convert<std::uint16_t>(attribute, points, components, out);
    case ComponentType::Uint32:
      return convert<std::uint32_t>(attribute, points, components, out);
    case ComponentType::Float:
      return convert<float>(attribute, points, components, out);
  }
  return false;
}

/// Whether all values are there, and the mapping for each point.
bool isComplete(const draco::PointAttribute& attribute, std::size_t points) {
  const std::size_t bytes = attribute.size() * static_cast<std::size_t>(attribute.byte_stride());
  const bool isMapped = attribute.is_mapping_identity() || attribute.indices_map_size() >= points;
  return isMapped && attribute.buffer() != nullptr && attribute.buffer()->data_size() >= bytes &&
         attribute.data_type() != draco::DT_BOOL;
}

}  // namespace

Result<DracoMesh> DracoMesh::decode(std::string_view bytes, Budget& budget) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader header{};
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok())
    return damaged("it does not start with the Draco header");
  if (header.encoder_type != draco::TRIANGULAR_MESH)
    return Status{StatusCode::ParseError,
                  " is a point cloud, not a mesh. Save the file without compression"};
  auto mesh = std::make_shared<draco::Mesh>();
  const Status status = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING
                            ? decodeWith<draco::MeshEdgebreakerDecoder>(*mesh, buffer, budget)
                        : header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING
                            ? decodeWith<draco::MeshSequentialDecoder>(*mesh, buffer, budget)
                            : damaged("its encoding method is unknown");
  if (!status.ok()) return status;
  if (mesh->num_faces() == 0) return damaged("it has no triangles");
  for (std::uint32_t f = 0; f < mesh->num_faces(); ++f)
    for (const draco::PointIndex& point : mesh->face(draco::FaceIndex(f)))
      if (point.value() >= mesh->num_points())
        return damaged("a triangle refers to a missing point");
  return DracoMesh(std::move(mesh));
}

std::size_t DracoMesh::points() const { return mesh_->num_points(); }

std::vector<std::uint32_t> DracoMesh::indices() const {
  std::vector<std::uint32_t> out;
  out.reserve(std::size_t{3} * mesh_->num_faces());
  for (std::uint32_t f = 0; f < mesh_->num_faces(); ++f)
    for (const draco::PointIndex& point : mesh_->face(draco::FaceIndex(f)))
      out.push_back(point.value());
  return out;
}

Result<std::string> DracoMesh::attribute(std::uint32_t id, ComponentType type,
                                         std::size_t components) const {
  const draco::PointAttribute* found = mesh_->GetAttributeByUniqueId(id);
  const std::string name = "attribute " + std::to_string(id);
  if (found == nullptr) return damaged("it has no " + name);
  if (found->num_components() != components)
    return damaged(name + " has " + std::to_string(found->num_components()) +
                   " components, but its accessor has " + std::to_string(components));
  std::string out;
  if (!isComplete(*found, points()) || !convertTo(type, *found, points(), components, out))
    return damaged(name + " has values that its accessor cannot hold");
  return out;
}

}  // namespace abflat::gltf
