// Passes serialised messages between standard streams and Fast DDS, with the service mapping of rmw_fastrtps.
//
// It first reads lines, "writer TOPIC TYPE latched" or "reader TOPIC TYPE DEPTH", and then "begin". After that, each message in
// both directions is a frame: number of the endpoint (2 bytes), length (4), identity of a request (24), and the bytes of CDR.
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

using namespace eprosima::fastdds::dds;
using namespace eprosima::fastrtps::rtps;

using Bytes = std::vector<uint8_t>;
constexpr uint32_t MOST_BYTES = 1 << 20;
constexpr size_t IDENTITY = 24;

// A type whose messages are bytes that the other process has serialised.
struct Serialised : TopicDataType {
  explicit Serialised(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 4096;
    m_isGetKeyDefined = false;
    auto_fill_type_information(false);
    auto_fill_type_object(false);
  }
  bool serialize(void* data, SerializedPayload_t* payload) override {
    auto& bytes = *static_cast<Bytes*>(data);
    payload->encapsulation = CDR_LE;
    payload->length = bytes.size();
    memcpy(payload->data, bytes.data(), bytes.size());
    return true;
  }
  bool deserialize(SerializedPayload_t* payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, InstanceHandle_t*, bool) override { return false; }
};

std::mutex output;

void put(uint16_t endpoint, const SampleIdentity& identity, const Bytes& bytes) {
  std::lock_guard<std::mutex> guard(output);
  uint32_t length = bytes.size();
  uint8_t id[IDENTITY];
  memcpy(id, identity.writer_guid().guidPrefix.value, 12);
  memcpy(id + 12, identity.writer_guid().entityId.value, 4);
  int64_t number = identity.sequence_number().to64long();
  memcpy(id + 16, &number, 8);
  fwrite(&endpoint, 2, 1, stdout);
  fwrite(&length, 4, 1, stdout);
  fwrite(id, IDENTITY, 1, stdout);
  fwrite(bytes.data(), 1, length, stdout);
  fflush(stdout);
}

struct Listener : DataReaderListener {
  uint16_t endpoint = 0;
  void on_data_available(DataReader* reader) override {
    Bytes bytes;
    SampleInfo info;
    while (reader->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      // As rmw_fastrtps: an answer names the request by the identity that the client has put into it, or by the sample's own.
      auto identity = info.sample_identity;
      auto& related = info.related_sample_identity;
      if (related.writer_guid() != GUID_t::unknown()) identity.writer_guid(related.writer_guid());
      put(endpoint, identity, bytes);
    }
  }
};

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: bridge DOMAIN [ADDRESS]" << std::endl;
    return 2;
  }
  DomainParticipantQos qos;
  // Without the address of an interface, Fast DDS has its defaults: all interfaces, and shared memory.
  if (argc == 3) {
    auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.push_back(argv[2]);
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(udp);
  }
  auto participant = DomainParticipantFactory::get_instance()->create_participant(atoi(argv[1]), qos);
  auto publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  auto subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  std::vector<DataWriter*> writers;
  std::vector<std::unique_ptr<Listener>> listeners;
  std::string line;
  // Byte by byte from the same stream as the frames that follow.
  auto read_line = [&] {
    line.clear();
    for (int c = getchar(); c != EOF && c != '\n'; c = getchar()) line.push_back(static_cast<char>(c));
    return !line.empty();
  };
  while (read_line() && line != "begin") {
    std::istringstream words(line);
    std::string role, name, type;
    int number = 0;
    words >> role >> name >> type >> number;
    TypeSupport support(new Serialised(type));
    support.register_type(participant);
    auto topic = participant->create_topic(name, type, TOPIC_QOS_DEFAULT);
    if (role == "writer") {
      DataWriterQos wanted;
      wanted.reliability().kind = RELIABLE_RELIABILITY_QOS;
      wanted.durability().kind = number ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
      wanted.history().depth = number ? 1 : 10;
      wanted.publish_mode().kind = SYNCHRONOUS_PUBLISH_MODE;
      wanted.endpoint().history_memory_policy = PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
      writers.push_back(publisher->create_datawriter(topic, wanted));
    } else {
      DataReaderQos wanted;
      wanted.reliability().kind = RELIABLE_RELIABILITY_QOS;
      wanted.history().depth = number;
      wanted.endpoint().history_memory_policy = PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
      listeners.push_back(std::make_unique<Listener>());
      listeners.back()->endpoint = listeners.size() - 1;
      subscriber->create_datareader(topic, wanted, listeners.back().get());
    }
  }
  uint16_t endpoint = 0;
  uint32_t length = 0;
  uint8_t id[IDENTITY];
  while (fread(&endpoint, 2, 1, stdin) == 1 && fread(&length, 4, 1, stdin) == 1 && fread(id, IDENTITY, 1, stdin) == 1) {
    if (endpoint >= writers.size() || length > MOST_BYTES) return 2;
    Bytes bytes(length);
    if (fread(bytes.data(), 1, length, stdin) != length) break;
    WriteParams parameters;
    GUID_t guid;
    int64_t number = 0;
    memcpy(guid.guidPrefix.value, id, 12);
    memcpy(guid.entityId.value, id + 12, 4);
    memcpy(&number, id + 16, 8);
    if (guid != GUID_t::unknown()) {
      SampleIdentity identity;
      identity.writer_guid(guid);
      identity.sequence_number(SequenceNumber_t(static_cast<int32_t>(number >> 32), static_cast<uint32_t>(number)));
      parameters.related_sample_identity(identity);
    }
    writers[endpoint]->write(&bytes, parameters);
  }
  _Exit(0);
}
